// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/engine.hpp"

namespace oplus {

/// Computes P ⊕ Q by the arrangement of the full convolution and the winding numbers of its faces:
/// a face is in the sum iff its winding number is positive (thesis, Theorem 4.2.1; Section 6.2.1,
/// the method of Wein). No face needs a hole test; low-dimensional features of the open sum do.
/// Requires: p and q are valid (validity.hpp).
ComputedSum sum_by_winding_numbers(const Region& p, const Region& q, Boundary boundary,
                                   const EngineOptions& options = {});

}  // namespace oplus
