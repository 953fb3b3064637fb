// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// Both sums of two regions, with the origins of their edges.
struct SumsAlongLines {
  MinkowskiSum closed;
  MinkowskiSum open;
  Origins origins_of_closed;
  Origins origins_of_open;
};

/// Computes P ⊕ Q without an arrangement and without any code of `checked/`, in integers of 64 bits where
/// they are enough. Along the line of each segment of the convolution 𝒞, winding numbers on both sides
/// change where segments cross it: a piece is on the boundary iff one of both is positive (thesis, Theorem
/// 4.2.1). Of the open sum, points and pieces where something may be missing are decided by the definition
/// (collision.hpp). For K segments O(K² log K), and as many collision tests as vertex sums.
/// Requires: p and q are valid and have a component.
SumsAlongLines sums_along_lines(const Region& p, const Region& q);

}  // namespace oplus
