// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Interval_nt.h>
#include <CGAL/mpq_class.h>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Certified double intervals. Requires, while one is computed with: a live
/// CGAL::Protect_FPU_rounding<true>.
using Interval = CGAL::Interval_nt<false>;

inline Interval interval(const Rational& value) { return Interval(CGAL::to_interval(value)); }

struct IntervalPoint {
  Interval x;
  Interval y;
};

inline IntervalPoint interval(const Point& p) { return {interval(p.x), interval(p.y)}; }

inline IntervalPoint operator+(const IntervalPoint& a, const IntervalPoint& b) {
  return {a.x + b.x, a.y + b.y};
}
inline IntervalPoint operator-(const IntervalPoint& a, const IntervalPoint& b) {
  return {a.x - b.x, a.y - b.y};
}

inline Interval cross(const IntervalPoint& u, const IntervalPoint& v) {
  return u.x * v.y - u.y * v.x;
}

/// A stage that may not know: the orientation of three points, or uncertain.
inline CGAL::Uncertain<CGAL::Sign> orientation(const IntervalPoint& a, const IntervalPoint& b,
                                               const IntervalPoint& c) {
  return CGAL::sign(cross(b - a, c - a));
}

struct IntervalSegment {
  IntervalPoint source;
  IntervalPoint target;
};

inline IntervalSegment interval(const Segment& s) {
  return {interval(s.source), interval(s.target)};
}

inline IntervalSegment translated(const IntervalSegment& s, const IntervalPoint& by) {
  return {s.source + by, s.target + by};
}

}  // namespace oplus
