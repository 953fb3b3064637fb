// SPDX-License-Identifier: MIT
#pragma once

#include "checked/operations/sum_of.hpp"

namespace oplus {

// Sums of which either summand may be unbounded: by a frame around it that is further away than the other one
// is wide and high (docs/operations.md). `sum` is called at most once.

/// Returns the sum of two valid regions.
PlanarSet unbounded_sum(const Region& p, const Region& q, Boundary boundary, const SumOf& sum);

/// Returns the sum of two closed sets in canonical form (set_sum.hpp).
PlanarSet unbounded_sum(const PlanarSet& p, const PlanarSet& q, Boundary boundary,
                        const SumOf& sum);

}  // namespace oplus
