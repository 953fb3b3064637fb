// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/arrangement/hole_test.hpp"
#include "checked/computed_sum.hpp"

namespace oplus {

/// Computes P ⊕ Q by the method of Behar and Lien (thesis, Section 3.1): orientable loops on the
/// arrangement of the reduced convolution, the nesting filter, and one hole test a loop.
/// Requires: p and q are valid (validity.hpp).
ComputedSum sum_by_loops(const Region& p, const Region& q, Boundary boundary,
                         WithOrigins with_origins = WithOrigins::no,
                         HoleTestMethod method = HoleTestMethod::hierarchy);

/// The same with a hole test for p and q that the caller has.
ComputedSum sum_by_loops(const Region& p, const Region& q, Boundary boundary,
                         WithOrigins with_origins, HoleTest& hole_test);

}  // namespace oplus
