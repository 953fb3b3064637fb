// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/placements/covered_sum.hpp"

#include <algorithm>

#include "reference/chains/touching_points.hpp"
#include "reference/definitions/direction.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

bool cover(const std::vector<Segment>& segments, const Segment& edge) {
  std::vector<Segment> along;
  for (const Segment& s : segments)
    if (overlap(s, edge)) along.push_back(s);
  return std::ranges::any_of(maximal_segments(along), [&](const Segment& s) {
    return lies_on(edge.source, s) && lies_on(edge.target, s);
  });
}

bool cover(const std::vector<ConvolutionSegment>& segments, const Vector& direction,
           const Segment& edge) {
  std::vector<Segment> along;
  for (const ConvolutionSegment& s : segments) {
    if (same_direction(direction_of(s.segment), direction)) along.push_back(s.segment);
  }
  return cover(along, edge);
}

std::string bare(const PlanarSet& sum, const std::vector<ConvolutionSegment>& segments,
                 const std::set<Point>& excepted) {
  const auto named = [](const Segment& edge) {
    return "from " + to_string(edge.source) + " to " + to_string(edge.target);
  };
  for (const Segment& edge : edges(PlanarSet{sum.outer, sum.holes, {}, {}})) {
    if (!cover(segments, direction_of(edge), edge))
      return "no segments of the same direction cover the edge " + named(edge);
  }
  for (const Segment& edge : sum.dangling_edges) {
    if (!cover(segments, direction_of(edge), edge) || !cover(segments, -direction_of(edge), edge))
      return "no opposite segments cover the dangling edge " + named(edge);
  }
  for (const Point& x : sum.isolated_vertices) {
    if (!excepted.contains(x) &&
        std::none_of(segments.begin(), segments.end(),
                     [&](const ConvolutionSegment& s) { return lies_on(x, s.segment); }))
      return "no segment passes through the isolated vertex " + to_string(x);
  }
  return "";
}

std::set<Point> sums_of_touching_points(const Summands& summands) {
  std::set<Point> sums;
  for (const Point& p : touching_points(summands.p))
    for (const Point& q : touching_points(summands.q)) sums.insert(p + q);
  return sums;
}

}  // namespace oplus
