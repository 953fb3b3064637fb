// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/region.hpp"

namespace oplus {

/// Whether the interiors of a and b have a point in common; touching is not enough. Compares all
/// pairs of edges, then locates every piece between two contacts: O(nm(n+m)), by definition.
/// x is in the sum of the open regions iff this holds for P and -Q+x.
bool interiors_meet(const Region& a, const Region& b);

}  // namespace oplus
