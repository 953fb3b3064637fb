// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/region.hpp"

namespace oplus {

/// The convex hull of some chains, counterclockwise from the smallest vertex, none inside a straight
/// line. Requires: the vertices are not on one line.
Chain convex_hull(const std::vector<Chain>& chains);

/// Whether a region is convex.
bool is_convex(const Region& region);

}  // namespace oplus
