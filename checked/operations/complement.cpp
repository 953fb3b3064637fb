// SPDX-License-Identifier: MIT
#include "checked/operations/complement.hpp"

#include "reference/chains/region_of.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

PlanarSet complement(const PlanarSet& set) {
  BoundaryFeatures features{{}, set.dangling_edges, set.isolated_vertices};
  if (OPLUS_MUTANT("complements-lose-their-points",
                   "isolated vertices of an open set are missing in its complement"))
    features.isolated_vertices.clear();
  // Chains are made anew: they are to go around faces of the complement.
  for (const Segment& piece : boundary_pieces(region_of(set)))
    features.edges.push_back(reversed(piece));
  PlanarSet result = canonical_sum(features);
  result.is_unbounded = !set.is_unbounded;
  return result;
}

Region complement(const Region& region) { return region_of(complement(canonical_sum(region))); }

}  // namespace oplus
