// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter2/overlay_points.hpp"

#include <algorithm>
#include <set>

#include "properties/statements/places/points_beside.hpp"
#include "reference/definitions/cut_at_intersections.hpp"

namespace oplus {

std::vector<OverlayPoint> overlay_points(const Region& a, const Region& b) {
  std::vector<Segment> both = edges(a);
  for (const Segment& e : edges(b)) both.push_back(e);
  const std::vector<Point> in_faces = points_beside(both);
  std::set<Point> cells(in_faces.begin(), in_faces.end());
  for (const std::vector<Segment>& of_edge : cut_at_intersections(both)) {
    for (const Segment& piece : of_edge)
      cells.insert({piece.source, piece.target, midpoint(piece.source, piece.target)});
  }
  std::vector<OverlayPoint> located;
  located.reserve(cells.size());
  for (const Point& x : cells) located.push_back({x, locate(x, a), locate(x, b)});
  return located;
}

bool have_common_interior(const std::vector<OverlayPoint>& points) {
  return std::any_of(points.begin(), points.end(), [](const OverlayPoint& x) {
    return x.in_a == Location::inside && x.in_b == Location::inside;
  });
}

}  // namespace oplus
