// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Where touching points of both summands meet, a vertex of the open sum may be isolated without a
/// segment of the reduced convolution through it (docs/findings.md, on Theorem 2.3.2). Returns these.
/// `found`, the open sum but for them, is asked for only where touching points meet.
std::vector<Point> isolated_touching_points(
    const Region& p, const Region& q, const std::function<bool(const Point&)>& interiors_meet_at,
    const std::function<PlanarSet()>& found);

}  // namespace oplus
