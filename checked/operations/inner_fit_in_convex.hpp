// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "reference/definitions/values.hpp"

namespace oplus {

/// inner_fit (operations.hpp) in a convex polygon, which contains what contains the points: of each x, all y between
/// a convex function and a concave one, which are piecewise linear. Empty where the chain is not convex, or there
/// is no point. O((n + m) log(n + m)). Requires: the chain is the boundary of a polygon, counterclockwise.
std::optional<PlanarSet> inner_fit_in_convex(const Chain& p, const std::vector<Point>& q);

}  // namespace oplus
