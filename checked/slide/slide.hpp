// SPDX-License-Identifier: MIT
#pragma once

#include "checked/engine.hpp"
#include "checked/slide/prepared_summand.hpp"

namespace oplus {

/// Computes P ⊕ Q from the reduced convolution without an arrangement: docs/slide.md.
/// Neither the sum nor the statistics depend on the number of threads.
/// Requires: p and q are valid (validity.hpp).
ComputedSum slide_sum(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options = {});

/// The same of summands that belong to many pairs: what depends on one of them alone is computed once.
ComputedSum sum_of_prepared(const slide::PreparedSummand& p, const slide::PreparedSummand& q,
                            Boundary boundary, const EngineOptions& options = {});

}  // namespace oplus
