// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reference/definitions/direction.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

/// For each summand, whether its interior is counterclockwise of a ray from a contact point, or
/// clockwise; empty where its boundary does not run along the ray.
using InteriorSides = std::array<std::optional<bool>, 2>;

/// Whether the interiors of the two summands meet in every neighbourhood of a contact point, given
/// all rays along which their boundaries leave it, in counterclockwise order, no two equal: whether
/// one of the sectors between neighbouring rays is inside both. Decides weak intersections and
/// overlaps (thesis, Section 5.1.1), and points at which several chains of a summand touch.
/// Evaluates no predicate.
bool is_sector_inside_both(const std::vector<InteriorSides>& rays);

/// A ray from a contact point along an edge of one summand.
struct BoundaryRay {
  Direction direction;
  bool interior_is_counterclockwise;  ///< which of its two sides is inside its summand
};

/// Appends the rays along an edge that passes through `at` or has an end there.
void add_rays(const Segment& edge, Summand of, const Point& at, std::vector<BoundaryRay>& rays);

/// The same for rays in any order, those of the two summands each on its own.
bool interiors_meet_around(std::vector<BoundaryRay> rays);

}  // namespace oplus
