// SPDX-License-Identifier: MIT
#pragma once

#include "checked/rounding/faces.hpp"
#include "checked/rounding/side.hpp"
#include "checked/rounding/snapped_edges.hpp"

namespace oplus {

// Faces are components of a set's interior, and of its complement: holes and the outside. Sets are bounded; dangling edges and
// isolated vertices are left out.

/// What became of the faces of a set, whose boundary was snapped: a face becomes those around points of which its own boundary
/// winds after it was moved. `after` is the set with the boundary that is left. Near-linear.
TopologyChanges changes_by_snapping(const Boundaries& before, const SnappedEdges& snapped,
                                    const std::vector<Point>& centres, const PlanarSet& after);

/// What became of the faces of a set that was rounded to a larger or a smaller one: each component of the smaller one is
/// contained in one of the larger one, and each face of the larger one's complement in one of the smaller one's.
/// Near-linear. Requires: one set contains the other.
TopologyChanges changes_by_containment(const PlanarSet& before, const PlanarSet& after,
                                       bool after_contains_before);

}  // namespace oplus
