// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/places/covered_sum.hpp"

#include <algorithm>

#include "reference/definitions/direction.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

bool cover(const std::vector<ConvolutionSegment>& segments, const Vector& direction,
           const Segment& edge) {
  std::vector<Segment> along;
  for (const ConvolutionSegment& s : segments) {
    if (same_direction(direction_of(s.segment), direction) && overlap(s.segment, edge))
      along.push_back(s.segment);
  }
  const std::vector<Segment> joined = maximal_segments(along);
  return std::any_of(joined.begin(), joined.end(), [&](const Segment& s) {
    return lies_on(edge.source, s) && lies_on(edge.target, s);
  });
}

std::string bare(const MinkowskiSum& sum, const std::vector<ConvolutionSegment>& segments,
                 const std::vector<Point>& excepted) {
  const auto named = [](const Segment& edge) {
    return "from " + to_string(edge.source) + " to " + to_string(edge.target);
  };
  for (const std::vector<Chain>* chains : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *chains) {
      for (const Segment& edge : edges(chain)) {
        if (!cover(segments, direction_of(edge), edge))
          return "no equally directed segments cover the edge " + named(edge);
      }
    }
  }
  for (const Segment& edge : sum.dangling_edges) {
    if (!cover(segments, direction_of(edge), edge) || !cover(segments, -direction_of(edge), edge))
      return "no opposite segments cover the dangling edge " + named(edge);
  }
  for (const Point& x : sum.isolated_vertices) {
    if (!std::binary_search(excepted.begin(), excepted.end(), x) &&
        std::none_of(segments.begin(), segments.end(),
                     [&](const ConvolutionSegment& s) { return lies_on(x, s.segment); }))
      return "no segment passes through the isolated vertex " + to_string(x);
  }
  return "";
}

}  // namespace oplus
