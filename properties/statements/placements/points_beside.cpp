// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/placements/points_beside.hpp"

#include <set>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/ray.hpp"

namespace oplus {

std::vector<Point> points_beside(const std::vector<Segment>& segments) {
  std::set<Segment> pieces;
  for (const std::vector<Segment>& of_segment : cut_at_intersections(segments)) {
    for (const Segment& piece : of_segment)
      pieces.insert(piece.target < piece.source ? reversed(piece) : piece);
  }
  std::vector<Point> points;
  points.reserve(2 * pieces.size());
  for (const Segment& piece : pieces) {
    const Point middle = midpoint(piece.source, piece.target);
    const Vector along = direction_of(piece);
    const Vector normal{along.y, -along.x};
    points.push_back(point_beside(middle, normal, segments));
    points.push_back(point_beside(middle, -normal, segments));
  }
  return points;
}

}  // namespace oplus
