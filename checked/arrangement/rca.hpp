// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/engine.hpp"

namespace oplus {

/// Computes P ⊕ Q by the thesis's own algorithm RCA (Sections 3.2 and 7.2): the arrangement of the
/// reduced convolution, whose edges know their segments; faces whose whole boundary is directed with
/// the face to its right are candidates for the complement (Lemma 3.1.2); a hole test each decides.
/// Requires: p and q are valid (validity.hpp).
ComputedSum rca(const Region& p, const Region& q, Boundary boundary,
                const EngineOptions& options = {});

}  // namespace oplus
