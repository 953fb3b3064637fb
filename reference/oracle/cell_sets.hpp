// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "reference/definitions/cells.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Whether each cell of an arrangement is in a set.
struct CellVerdicts {
  std::vector<bool> faces, edges, vertices;
};

/// The boundary of a set of cells: edges between a face in it and one that is not; dangling are edges in
/// a closed set, and missing in an open one, where both faces are otherwise; likewise vertices.
/// Throws VerdictsDiffer where the cells that are in it are no closed, or no open, set.
BoundaryFeatures features_of(const Cells& cells, const CellVerdicts& in_set, Boundary boundary);

/// The set of all points for which `contains` holds, asked once in each cell of the arrangement of the
/// segments. Requires: it does not change inside a cell. Throws as features_of().
PlanarSet set_where(const std::vector<Segment>& segments, Boundary boundary,
                    const std::function<bool(const Point&)>& contains);

}  // namespace oplus
