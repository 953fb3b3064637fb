// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter5/placements.hpp"

#include <vector>

#include "properties/statements/places/points_beside.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"

namespace oplus {

std::set<Point> placements(const Summands& summands) {
  const std::vector<Point> beside = points_beside(segments(convolution(summands.p, summands.q)));
  std::set<Point> result(beside.begin(), beside.end());
  for (const auto& pieces :
       cut_at_intersections(segments(vertex_edge_sum(summands.p, summands.q)))) {
    for (const Segment& piece : pieces)
      result.insert({piece.source, piece.target, midpoint(piece.source, piece.target)});
  }
  return result;
}

}  // namespace oplus
