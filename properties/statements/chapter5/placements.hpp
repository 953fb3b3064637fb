// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "reference/families/family.hpp"

namespace oplus {

/// Every kind of placement of -Q that there is: one in each face of the convolution's arrangement,
/// one inside each piece of the vertex-edge sum, where a vertex is on an edge, and each end of a
/// piece, where vertices meet or several vertices are on edges.
std::set<Point> placements(const Summands& summands);

}  // namespace oplus
