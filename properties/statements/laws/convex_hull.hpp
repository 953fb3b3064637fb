// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/region.hpp"

namespace oplus {

/// The convex hull of the points, counterclockwise from the smallest, no vertex inside a straight
/// line. Requires: the points are not on one line.
Chain convex_hull(const std::vector<Point>& points);

/// Whether a region is convex.
bool is_convex(const Region& region);

}  // namespace oplus
