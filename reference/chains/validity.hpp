// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "reference/definitions/region.hpp"

namespace oplus {

/// What can be wrong with a region. A valid one (thesis, Definition 2.1.17) has simple chains
/// (Definition 2.1.4) that may touch each other in points, but neither cross nor overlap.
enum class DefectKind {
  too_few_vertices,    ///< a chain of fewer than three vertices
  zero_length_edge,    ///< two consecutive vertices are equal
  repeated_vertex,     ///< two other vertices of a chain are equal
  self_crossing,       ///< two edges of a chain cross
  self_overlap,        ///< two edges of a chain share a segment
  self_touching,       ///< a vertex lies inside an edge of its own chain
  chains_cross,        ///< the edges of two chains cross, or one passes through a vertex
  chains_overlap,      ///< the edges of two chains share a segment
  hole_outside,        ///< a hole is not inside its outer chain
  holes_nested,        ///< a hole is inside another hole of its component
  components_overlap,  ///< a component lies in the interior of another
};

struct Defect {
  DefectKind kind;
  VertexIndex first;   ///< the vertex, or the edge that leaves it
  VertexIndex second;  ///< the other one; equal to `first` where there is none
  Point where;         ///< a point at which it shows
};

/// Returns a short phrase in the field's words, such as "edges cross".
std::string describe(DefectKind kind);

/// Returns a defect of the region; empty if it is valid. Of several, it is one of the vertices of a chain
/// (too few, or equal ones); otherwise one of those at the smallest point at which edges have
/// one; otherwise one of a chain that is where it may not be. The order of a chain's vertices, whether
/// counterclockwise or not, does not matter. O(n log n) for n vertices; a plane sweep decides.
std::optional<Defect> find_defect(const Region& region);

}  // namespace oplus
