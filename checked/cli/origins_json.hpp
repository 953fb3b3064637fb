// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Returns a JSON list with an object, on a line of its own, for each edge of the sum, in the order
/// of `edges(sum)`:
///
///   {"kind": "outer" | "hole" | "dangling",
///    "from": ["x", "y"], "to": ["x", "y"],
///    "origins": [{"edge": {"of": "P", "chain": 0, "leaves": 3, "from": [...], "to": [...]},
///                 "vertex": {"of": "Q", "chain": 0, "index": 1, "at": [...]}}, ...]}
///
/// Each origin is an edge of one summand and a vertex of the other whose sum runs along the edge.
/// Coordinates are strings, exact. Chains and vertices are counted from zero as in the input, an
/// outer chain before its holes, after orientation was repaired.
/// Requires: the origins belong to the sum.
std::string origins_json(const PlanarSet& sum, const Origins& origins, const Region& p,
                         const Region& q);

}  // namespace oplus
