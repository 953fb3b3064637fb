// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/rational.hpp"

namespace oplus {

inline Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator-(const Point& a) { return {-a.x, -a.y}; }
inline Point operator*(const Rational& factor, const Point& a) {
  return {factor * a.x, factor * a.y};
}

inline Point midpoint(const Point& a, const Point& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// The skew product [u, v] (thesis, Definition 2.1.9).
inline Rational cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }
inline Rational dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }

/// Returns 1 if a, b, c turn left, -1 if they turn right, 0 if they are collinear.
inline int orientation(const Point& a, const Point& b, const Point& c) {
  const int compared =
      cmp(Rational((b.x - a.x) * (c.y - a.y)), Rational((b.y - a.y) * (c.x - a.x)));
  return (compared > 0) - (compared < 0);
}

}  // namespace oplus
