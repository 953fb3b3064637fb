// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Returns a point near x in every cell, edge or face, of the segments' arrangement that x touches
/// from strictly to the left of a line through x along the given direction: whatever is constant in
/// cells holds in a small half disk iff it holds in these points.
/// Requires: along is not zero.
std::vector<Point> points_to_the_left(const Point& x, const Vector& along,
                                      const std::vector<Segment>& segments);

/// The same on all sides of x.
std::vector<Point> points_around(const Point& x, const std::vector<Segment>& segments);

}  // namespace oplus
