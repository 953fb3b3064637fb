// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/segment.hpp"

namespace oplus {

inline Rational squared_length(const Vector& v) { return dot(v, v); }

/// The square of the distance of x from a closed segment, which may be a point.
inline Rational squared_distance(const Point& x, const Segment& s) {
  if (x == s.source || x == s.target) return 0;  // cheaper than computing it
  const Vector along = direction_of(s);
  const Vector to = x - s.source;
  const Rational at = dot(along, to);
  if (at <= 0) return squared_length(to);
  const Rational length = squared_length(along);
  if (at >= length) return squared_length(x - s.target);
  const Rational across = cross(along, to);
  return across * across / length;
}

/// The point of a closed segment, which may be a point, that is nearest to x.
inline Point nearest_point(const Point& x, const Segment& s) {
  const Vector along = direction_of(s);
  const Rational at = dot(along, x - s.source);
  if (at <= 0) return s.source;
  const Rational length = squared_length(along);
  return at >= length ? s.target : s.source + at / length * along;
}

}  // namespace oplus
