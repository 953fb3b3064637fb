// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/claimed_sum.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Whether a given set and the right one differ near the right one's boundary only, as a set does that was rounded to a
/// grid: with S for the given set, R for the right one, and a square of the diagonal 2D, which is in the disk of radius D,
///  1. S is contained in R grown by the square, and the complement of S in that of R, with its dangling edges and isolated vertices, grown by it: so each point in
///     which S and R differ is at most D from the boundary of R;
///  2. each point of a dangling edge and each isolated vertex of R is outside of S, or at most D from its boundary.
/// `boundary_of_given` is that of S, points as segments, too. Exact, but that the square's side is a rational, smaller by
/// a 2^64th or less. Requires: D >= 0.
bool differs_near_only(const PlanarSet& right, const ClaimedSum& given,
                       const std::vector<Segment>& boundary_of_given, const Rational& distance);

}  // namespace oplus
