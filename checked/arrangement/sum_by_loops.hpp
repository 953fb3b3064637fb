// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/engine.hpp"

namespace oplus {

/// Computes P ⊕ Q by the method of Behar and Lien (thesis, Section 3.1): orientable loops on the
/// arrangement of the reduced convolution, the nesting filter, and one hole test a loop.
/// Requires: p and q are valid (validity.hpp).
ComputedSum sum_by_loops(const Region& p, const Region& q, Boundary boundary,
                         const EngineOptions& options = {});

}  // namespace oplus
