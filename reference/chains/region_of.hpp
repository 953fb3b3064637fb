// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

// A sum as a region, and a region as a sum. Each takes O(n log n) for n vertices and touching points.

/// The regularized sum as a region (thesis, Definition 2.1.17): chains that touch themselves are
/// taken apart into simple ones, and each hole goes to the outer chain directly around it, or, in an unbounded
/// sum, to the last component, which has none.
Region region_of(const PlanarSet& sum);

/// The same with its dangling edges and isolated vertices.
inline ClaimedSum parts_of(const PlanarSet& sum) {
  return {region_of(sum), sum.dangling_edges, sum.isolated_vertices};
}

/// The sum that is just this valid region: its chains in canonical form.
PlanarSet canonical_sum(const Region& region);

/// A sum by its chains. A hole goes to the outer chain directly around it; one around which there is
/// none is the only chain of its component, whose outer chain is empty. Nothing is required: where chains
/// cross, any outer chain, or none, may count as the one around a hole.
ClaimedSum given(const PlanarSet& sum);

}  // namespace oplus
