// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/generic_placements.hpp"

#include "properties/statements/chapter4/points_in_faces.hpp"
#include "reference/definitions/original_convolution.hpp"

namespace oplus {

std::vector<Point> generic_placements(const Summands& summands) {
  const auto& [p, q] = summands;
  std::vector<Segment> both = segments(convolution(p, q));
  for (const Segment& s : segments(original_convolution(p, q))) both.push_back(s);
  return points_in_faces(both, segments(vertex_edge_sum(p, q)));
}

}  // namespace oplus
