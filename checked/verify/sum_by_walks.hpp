// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "checked/verify/placements.hpp"
#include "reference/definitions/minkowski_sum.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// Computes P ⊕ Q by walking along each segment of the convolution, from infinity, and counting the
/// winding number of the points just to its right: what lies between a place outside the sum and
/// one inside is the boundary (thesis, Theorem 4.2.1). Nothing but that theorem is used, and no
/// arrangement is built: O(K²) signs for K segments, and O(I log I) for I intersections.
///
/// Dangling edges and isolated vertices are what the collision test leaves of the places where they
/// can be: docs/verify.md.
/// Requires: p and q are those of `placements`.
MinkowskiSum sum_by_walks(const Region& p, const Region& q, Boundary boundary,
                          const Placements& placements);

/// Segments on which all points lie that are in the interior of the closed sum and not in the open
/// one, with the boundary of both: the convolution, and the contacts of vertices in which chains touch.
std::vector<Segment> exceptional_places(const Region& p, const Region& q);

}  // namespace oplus
