// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cfloat>
#include <limits>

#include "reference/arithmetic/interval.hpp"

namespace oplus {

/// The points whose coordinates are between these doubles. It is certain to contain what it was made of:
/// numbers that are no doubles are given as intervals. (slide has a box of its own, of floats in a SIMD register.)
struct Box {
  double low_x = std::numeric_limits<double>::infinity(), low_y = low_x;  ///< empty
  double high_x = -low_x, high_y = high_x;

  /// Half the circumference.
  double size() const { return (high_x - low_x) + (high_y - low_y); }
};

/// The smallest box around two.
inline Box around(const Box& a, const Box& b) {
  return {std::min(a.low_x, b.low_x), std::min(a.low_y, b.low_y), std::max(a.high_x, b.high_x),
          std::max(a.high_y, b.high_y)};
}

inline Box box_of(const IntervalPoint& p) { return {p.x.low, p.y.low, p.x.high, p.y.high}; }
inline Box box_of(const IntervalSegment& s) { return around(box_of(s.source), box_of(s.target)); }

/// The Minkowski sum, each number rounded to nearest.
inline Box operator+(const Box& a, const Box& b) {
  return {a.low_x + b.low_x, a.low_y + b.low_y, a.high_x + b.high_x, a.high_y + b.high_y};
}

/// Larger by a margin on each side, and by more than what rounding takes away from this and from one sum.
inline Box enlarged(const Box& box, double margin) {
  const Interval x = outward(box.low_x - margin, box.high_x + margin);
  const Interval y = outward(box.low_y - margin, box.high_y + margin);
  return {x.low, y.low, x.high, y.high};
}

/// Around all places that a box is moved to.
inline Box translated(const Box& box, const IntervalPoint& by) {
  return enlarged(box + box_of(by), 0);
}

inline bool meet(const Box& a, const Box& b) {
  return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
}

/// At most the squared distance of any two points of the boxes: each of the five operations is wrong by
/// a 2^53rd at most, or by the least double.
inline double squared_gap(const Box& a, const Box& b) {
  const double x = std::max({0.0, a.low_x - b.high_x, b.low_x - a.high_x});
  const double y = std::max({0.0, a.low_y - b.high_y, b.low_y - a.high_y});
  const double squared = x * x + y * y;
  return squared < DBL_MIN ? 0 : squared * (1 - 0x1p-48);
}

}  // namespace oplus
