// SPDX-License-Identifier: MIT
#pragma once

#include "checked/engine.hpp"

namespace oplus {

/// Computes P ⊕ Q from the reduced convolution without an arrangement: docs/slide.md.
/// Neither the sum nor the statistics depend on the number of threads.
/// Requires: p and q are valid (validity.hpp).
ComputedSum slide_sum(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options = {});

}  // namespace oplus
