// SPDX-License-Identifier: MIT
#pragma once

#include "checked/engine.hpp"
#include "checked/oplus/oplus.hpp"

namespace oplus {

/// Computes a sum as the options say, but for their boundary. Requires: p and q are bounded.
ComputedSum computed_sum(const Region& p, const Region& q, Boundary boundary,
                         const SumOptions& options);

/// Requires: the set is in canonical form.
ValidSet set_of(PlanarSet value, Boundary boundary, Origins origins = {},
                Statistics statistics = {});

}  // namespace oplus
