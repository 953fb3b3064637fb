// SPDX-License-Identifier: MIT
#pragma once

#include "checked/verify/verdict.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// Whether a given sum is exactly P ⊕ Q, decided by the definitions and by no engine:
/// docs/verify.md. Requires: p and q are valid (validity.hpp); of the given sum nothing: where its chains
/// cross, it is refused, whichever outer chain the holes of a PlanarSet go to (region_of.hpp). Throws
/// VerdictsDiffer (reference/definitions/verdicts_differ.hpp) where convex parts and the collision test differ.
Verdict verify(const Region& p, const Region& q, Boundary boundary, const ClaimedSum& sum);
Verdict verify(const Region& p, const Region& q, Boundary boundary, const PlanarSet& sum);

/// P ⊕ Q by the definitions, as `verify` computes it: sum_by_convex_parts.hpp. Asks the collision test on
/// both sides of each chain. Requires: p and q are valid. Throws VerdictsDiffer.
PlanarSet sum_by_definition(const Region& p, const Region& q, Boundary boundary);

}  // namespace oplus
