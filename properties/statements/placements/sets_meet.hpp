// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/region.hpp"

namespace oplus {

// Sets by their parts: a valid region, segments and points, which may overlap. All pairs of parts are
// compared: O(nm), or O(nm(n + m)).

/// Whether two closed sets have a point in common.
bool meet(const ClaimedSum& a, const ClaimedSum& b);

/// Whether a region's interior and a closed set have a point in common.
bool interior_meets(const Region& a, const ClaimedSum& b);

/// The set of all x - p for points p of a set.
ClaimedSum reflected_to(const Point& x, const ClaimedSum& set);

/// A point of each cell of an arrangement such that each cell is inside, or outside, of the closed sum of
/// two sets, and of the open one: sums of their vertices with their edges bound it.
std::vector<Point> points_of_cells(const ClaimedSum& p, const ClaimedSum& q);

}  // namespace oplus
