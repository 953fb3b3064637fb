// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// An edge between two of some points, which are sorted, by their numbers.
struct NumberedEdge {
  std::uint32_t from;
  std::uint32_t to;

  friend auto operator<=>(const NumberedEdge&, const NumberedEdge&) = default;
};

/// The closed set that edges bound, in canonical form. Requires: they meet at ends only, the set to their left.
PlanarSet set_bounded_by(const std::vector<Point>& points, std::vector<NumberedEdge> edges);

/// The simple chains around each component of its interior and the holes in it: as programs want polygons whose interior is
/// connected. Requires: as above.
Region region_with_connected_interiors(const std::vector<Point>& points,
                                       std::vector<NumberedEdge> edges);

/// The same of a valid and bounded region.
Region with_connected_interiors(Region region);

/// The edges of a bounded set, cut where others touch them, with the set on the left, and the faces on both sides.
struct Boundaries {
  struct Edge {
    const Point* source;  ///< of the set
    const Point* target;
    std::uint32_t left;  ///< a connected component of the set's interior, counted from 0
    std::uint32_t
        right;  ///< a hole, likewise: a bounded component of the complement; the outside has the last number

    Segment segment() const { return {*source, *target}; }
  };
  std::vector<Edge> edges;
  std::uint32_t component_count = 0;
  std::uint32_t hole_count = 0;  ///< and the number of the outside
};

/// Without dangling edges and isolated vertices. O(n log n). Requires: the set is bounded, in canonical form, and stays
/// where it is.
Boundaries boundaries_of(const PlanarSet& set);

}  // namespace oplus
