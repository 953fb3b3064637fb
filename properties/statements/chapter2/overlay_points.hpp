// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// Where a point of the plane is with respect to two regions.
struct OverlayPoint {
  Point point;
  Location in_a;
  Location in_b;
};

/// A point of every cell, vertex, edge or face, of the overlay of two boundaries, each located by
/// winding numbers alone, one region at a time: no test for collision, no shortcut.
std::vector<OverlayPoint> overlay_points(const Region& a, const Region& b);

/// Whether one of the points is inside both: by definition, the interiors meet.
bool have_common_interior(const std::vector<OverlayPoint>& points);

}  // namespace oplus
