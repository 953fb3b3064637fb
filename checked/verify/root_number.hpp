// SPDX-License-Identifier: MIT
#pragma once

#include <compare>

#include "reference/definitions/rational.hpp"

namespace oplus {

/// a + b √c, c not negative: where a line meets a circle.
struct RootNumber {
  Rational a;
  Rational b = 0;
  Rational c = 0;
};

/// Returns -1, 0 or 1.
inline int sign(const RootNumber& x) {
  const int of_a = sign(x.a);
  const int of_b = sign(x.b) * sign(x.c);
  if (of_a == of_b || of_b == 0) return of_a;
  if (of_a == 0) return of_b;
  // Of different signs: the larger square decides.
  return of_a * sign(Rational(x.a * x.a - x.b * x.b * x.c));
}

/// Exact.
inline std::strong_ordering operator<=>(const RootNumber& x, const RootNumber& y) {
  // x - y = r + s, s the root of y.
  const RootNumber r{x.a - y.a, x.b, x.c};
  const int of_r = sign(r);
  const int of_s = -sign(y.b) * sign(y.c);
  if (of_r == of_s || of_s == 0) return of_r <=> 0;
  if (of_r == 0) return of_s <=> 0;
  const RootNumber difference_of_squares{r.a * r.a + r.b * r.b * r.c - y.b * y.b * y.c,
                                         2 * r.a * r.b, r.c};
  return of_r * sign(difference_of_squares) <=> 0;
}

}  // namespace oplus
