// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// Computes P ⊕ Q as the union of sums of convex parts (convex_sums.hpp): of each segment of the
/// reduced convolution, what is in none of them (thesis, Theorem 2.3.2; docs/verify.md). For K such
/// segments that is K searches in two trees of boxes, and no collision test. Where chains of both
/// summands touch, the sums of these points are also examined.
/// Requires: p and q are valid (validity.hpp).
PlanarSet sum_by_convex_parts(const Region& p, const Region& q, Boundary boundary);

}  // namespace oplus
