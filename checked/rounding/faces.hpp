// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// The simple chains around each component of the interior and the holes in it: as programs want polygons whose interior is
/// connected. Requires: edges meet at ends only, the set to their left.
Region region_with_connected_interiors(std::vector<Segment> edges);

/// The same of a valid and bounded region.
Region with_connected_interiors(const Region& region);

/// The edges of a bounded set, cut where others touch them, with the set on the left, and the faces on both sides.
struct Boundaries {
  std::vector<Segment> edges;
  std::vector<std::size_t> left;  ///< connected components of the set's interior, counted from 0
  std::vector<std::size_t>
      right;  ///< holes, likewise: bounded components of the complement; the outside has the last number
  std::size_t component_count = 0;
  std::size_t hole_count = 0;  ///< and the number of the outside
};

/// Without dangling edges and isolated vertices. O(n log n). Requires: the set is bounded.
Boundaries boundaries_of(const PlanarSet& set);

}  // namespace oplus
