// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/laws/overlaid_sums.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "properties/statements/places/points_beside.hpp"
#include "reference/definitions/cut_at_intersections.hpp"

namespace oplus {

std::vector<OverlaidPoint> overlaid(const std::vector<MinkowskiSum>& sums) {
  std::vector<Segment> all;
  std::vector<Point> isolated;
  for (const MinkowskiSum& sum : sums) {
    std::ranges::copy(edges(sum), std::back_inserter(all));
    std::ranges::copy(sum.isolated_vertices, std::back_inserter(isolated));
  }
  const std::vector<Point> in_faces = points_beside(all);
  std::set<Point> points(in_faces.begin(), in_faces.end());
  points.insert(isolated.begin(), isolated.end());
  for (const std::vector<Segment>& of_edge : cut_at_intersections(all)) {
    for (const Segment& of_sums : of_edge) {
      for (const Segment& piece : cut(of_sums, isolated))
        points.insert({piece.source, piece.target, midpoint(piece.source, piece.target)});
    }
  }
  std::vector<OverlaidPoint> result;
  for (const Point& p : points) {
    OverlaidPoint located{p, {}};
    for (const MinkowskiSum& sum : sums) located.in.push_back(locate(p, sum));
    result.push_back(std::move(located));
  }
  return result;
}

}  // namespace oplus
