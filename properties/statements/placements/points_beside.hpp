// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Returns, for each piece of the segments between intersections, a point in the face to either
/// side of it. So every face of the segments' arrangement contains one of the points, and none is
/// on a segment.
std::vector<Point> points_beside(const std::vector<Segment>& segments);

}  // namespace oplus
