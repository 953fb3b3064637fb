// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// The sums of each dangling edge and each isolated vertex of a set with the square [-half, half]²: convex polygons, which
/// may overlap. Requires: half > 0.
std::vector<Component> grown_features(const MinkowskiSum& set, const Rational& half);

/// The union of a region and those, as a set. Requires: the region is valid.
MinkowskiSum with_grown_features(const Region& region, const MinkowskiSum& set,
                                 const Rational& half);

}  // namespace oplus
