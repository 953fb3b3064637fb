// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "reference/definitions/values.hpp"

namespace oplus::certificates {

/// The line a x + b y + c = 0, and the half plane where that is positive.
struct IntegerLine {
  mpz_class a;
  mpz_class b;
  mpz_class c;
};

/// The point (x / w, y / w), w > 0.
struct HomogeneousPoint {
  mpz_class x;
  mpz_class y;
  mpz_class w;
};

inline void divide_by_common_factor(mpz_class& a, mpz_class& b, mpz_class& c) {
  mpz_class common = gcd(a, b);
  if (common != 1) common = gcd(common, c);
  if (common == 1 || common == 0) return;
  for (mpz_class* number : {&a, &b, &c})
    mpz_divexact(number->get_mpz_t(), number->get_mpz_t(), common.get_mpz_t());
}

inline HomogeneousPoint homogeneous(const Point& p) {
  const mpz_class w = lcm(p.x.get_den(), p.y.get_den());
  return {p.x.get_num() * (w / p.x.get_den()), p.y.get_num() * (w / p.y.get_den()), w};
}

inline Point point_of(const HomogeneousPoint& p) {
  return {Rational(p.x) / Rational(p.w), Rational(p.y) / Rational(p.w)};
}

/// Positive to the left of the line, where a x + b y + c is, negative to its right.
inline int side_of(const IntegerLine& line, const HomogeneousPoint& p) {
  const mpz_class value = line.a * p.x + line.b * p.y + line.c * p.w;
  return sgn(value);
}

/// Negative where p comes before q in the direction (b, -a), that of a walk with the positive side to its left.
inline int order_along(const IntegerLine& line, const HomogeneousPoint& p,
                       const HomogeneousPoint& q) {
  const auto along = [&](const HomogeneousPoint& v) {
    return mpz_class(line.b * v.x - line.a * v.y);
  };
  const mpz_class difference = along(p) * q.w - along(q) * p.w;
  return sgn(difference);
}

/// The line from p to q, whose left side is positive. Requires: p and q differ.
inline IntegerLine line_through(const HomogeneousPoint& p, const HomogeneousPoint& q) {
  IntegerLine line{p.y * q.w - q.y * p.w, q.x * p.w - p.x * q.w, p.x * q.y - q.x * p.y};
  divide_by_common_factor(line.a, line.b, line.c);
  return line;
}

/// Requires: the lines are not parallel.
inline HomogeneousPoint meet(const IntegerLine& l, const IntegerLine& m) {
  HomogeneousPoint p{l.b * m.c - m.b * l.c, l.c * m.a - m.c * l.a, l.a * m.b - m.a * l.b};
  divide_by_common_factor(p.x, p.y, p.w);
  if (sgn(p.w) < 0) {
    p.x = -p.x;
    p.y = -p.y;
    p.w = -p.w;
  }
  return p;
}

}  // namespace oplus::certificates
