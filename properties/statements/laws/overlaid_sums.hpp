// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/difference.hpp"

namespace oplus {

/// A point and where it lies with respect to each of several sums.
struct OverlaidPoint {
  Point point;
  std::vector<Location> in;
};

/// A point of every cell, vertex, edge or face, of the overlay of the boundaries of the sums,
/// dangling edges and isolated vertices included: what holds for these points holds for the plane.
std::vector<OverlaidPoint> overlaid(const std::vector<MinkowskiSum>& sums);

}  // namespace oplus
