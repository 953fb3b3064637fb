// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// The winding number of p with respect to the closed cycles that the directed segments form
/// (thesis, Definitions 4.2.2 and 4.2.3): signed crossings of the ray from p to the right, each
/// segment without its upper end, so that a ray through a vertex counts right.
/// Requires: the segments form cycles; p is on none of them.
int winding_number(const Point& p, const std::vector<Segment>& segments);

}  // namespace oplus
