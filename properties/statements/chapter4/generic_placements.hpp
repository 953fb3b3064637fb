// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/families/family.hpp"

namespace oplus {

/// Placements x of -Q in general position, at least one in each face of the arrangement of 𝒞 ∪ 𝒞′:
/// on no segment of the vertex-edge sum, so that no vertex of P or -Q+x is on the other's boundary.
std::vector<Point> generic_placements(const Summands& summands);

}  // namespace oplus
