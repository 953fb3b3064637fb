// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace oplus {

// Segments between points of machine integers. Require: products of differences fit.

/// Positive if a, b, c turn left, negative if they turn right, 0 if they are collinear.
template <typename IntegerPoint>
auto turn(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether the segments from `end` to u and to v overlap. Requires: u and v differ from `end`.
template <typename IntegerPoint>
bool runs_into(const IntegerPoint& u, const IntegerPoint& end, const IntegerPoint& v) {
  return turn(u, end, v) == 0 && (u.x - end.x) * (v.x - end.x) + (u.y - end.y) * (v.y - end.y) > 0;
}

/// Whether the closed segments from a to b and from c to d have a point in common.
template <typename IntegerPoint>
bool segments_meet(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c,
                   const IntegerPoint& d) {
  const bool boxes_meet =
      std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
      std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
  if (!boxes_meet) return false;
  const auto on_one_side = [](auto u, auto v) { return (u > 0 && v > 0) || (u < 0 && v < 0); };
  return !on_one_side(turn(a, b, c), turn(a, b, d)) && !on_one_side(turn(c, d, a), turn(c, d, b));
}

}  // namespace oplus
