// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/difference.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

/// A point and where it lies with respect to each of several regions or sums.
struct OverlaidPoint {
  Point point;
  std::vector<Location> in;

  /// Whether it is in one of them, as an open set or as a closed one.
  bool is_in(std::size_t i, bool open) const {
    return open ? in[i] == Location::inside : in[i] != Location::outside;
  }
};

/// A point of every cell (vertex, edge or face) of the overlay of all boundaries, dangling edges
/// and isolated vertices, located in one region or sum at a time; no collision test is used. What
/// holds for these points holds for the whole plane.
std::vector<OverlaidPoint> overlaid(const std::vector<Region>& regions);
std::vector<OverlaidPoint> overlaid(const std::vector<PlanarSet>& sums);

/// Returns, for each piece of the segments between intersections, a point in the face to either
/// side of it. So every face of the segments' arrangement contains one of the points, and none is
/// on a segment.
std::vector<Point> points_beside(const std::vector<Segment>& segments);

}  // namespace oplus
