// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/cells.hpp"

#include "reference/chains/region_of.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

Region region_of_cells(const Cells& cells) {
  BoundaryFeatures boundary;
  const auto add_side = [&](const std::pair<int, int>& neighbour, const Segment& side) {
    if (!cells.contains(neighbour)) boundary.edges.push_back(side);
  };
  for (const auto& [x, y] : cells) {
    const Point a{x, y}, b{x + 1, y}, c{x + 1, y + 1}, d{x, y + 1};
    add_side({x, y - 1}, {a, b});
    add_side({x + 1, y}, {b, c});
    add_side({x, y + 1}, {c, d});
    add_side({x - 1, y}, {d, a});
  }
  return region_of(canonical_sum(boundary));
}

}  // namespace oplus
