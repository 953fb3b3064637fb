// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/placements/overlay.hpp"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <set>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/ray.hpp"

namespace oplus {

namespace {

template <typename PointSet>
std::vector<OverlaidPoint> overlaid_with(const std::vector<PointSet>& sets,
                                         const std::vector<Point>& isolated) {
  std::vector<Segment> all;
  for (const PointSet& set : sets) std::ranges::copy(edges(set), std::back_inserter(all));
  const std::vector<Point> in_faces = points_beside(all);
  std::set<Point> points(in_faces.begin(), in_faces.end());
  points.insert(isolated.begin(), isolated.end());
  for (const Segment& of_sets : cut_at_intersections(all) | std::views::join) {
    for (const Segment& piece : cut(of_sets, isolated))
      points.insert({piece.source, piece.target, midpoint(piece.source, piece.target)});
  }
  std::vector<OverlaidPoint> result;
  for (const Point& p : points) {
    OverlaidPoint located{p, {}};
    for (const PointSet& set : sets) located.in.push_back(locate(p, set));
    result.push_back(std::move(located));
  }
  return result;
}

}  // namespace

std::vector<OverlaidPoint> overlaid(const std::vector<Region>& regions) {
  return overlaid_with(regions, {});
}

std::vector<OverlaidPoint> overlaid(const std::vector<PlanarSet>& sums) {
  std::vector<Point> isolated;
  for (const PlanarSet& sum : sums)
    std::ranges::copy(sum.isolated_vertices, std::back_inserter(isolated));
  return overlaid_with(sums, isolated);
}

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
