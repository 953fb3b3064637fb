// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/point.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// Some points on the boundary of the closed sum: where a straight path enters or leaves the open
/// one, which is decided by collision tests.
std::vector<Point> some_boundary_points(const Summands& summands);

}  // namespace oplus
