// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// How the winding number changes along from → to, where it crosses s (thesis, Definition 4.2.3), if the
/// path is shifted by (ε, ε²) for an infinitesimal ε > 0: 1 from the right of s to its left, -1 from left to
/// right, 0 if it does not cross. The shift leaves the ends of a path in their faces, and no vertex on
/// the path. Requires: neither the step nor s is a point.
int signed_crossing(const Point& from, const Point& to, const Segment& s);

/// The sum of a path's signed crossings with the segments, step by step; a step of length zero crosses
/// nothing. Requires: no segment is a point.
int signed_crossings(const std::vector<Point>& path, const std::vector<Segment>& segments);

}  // namespace oplus
