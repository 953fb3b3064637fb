// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/compare/engine_failure.hpp"
#include "properties/compare/peers/method.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// The regularized sum that is to the left of closed chains. They may touch themselves or each other
/// in points, and may have vertices inside straight lines. Nothing is repaired: with chains of fewer
/// than three vertices, edges of length zero, edges that cross, overlap or go back along one another,
/// and chains that have the sum on both sides or on the wrong one, they are not the boundary of a
/// region. O(n²). Throws EngineFailure: unreadable.
PlanarSet sum_of_chains(const ReturnedChains& chains);

}  // namespace oplus
