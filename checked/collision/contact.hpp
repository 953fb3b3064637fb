// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "reference/arithmetic/interval.hpp"
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

/// A ray from a contact point along an edge of one summand, ahead or back. The interior is to the left of the edge:
/// counterclockwise of the ray ahead, clockwise of the ray that leads back.
struct BoundaryRay {
  const Segment* edge;  ///< wherever it is moved to
  IntervalPoint near;   ///< the direction of the ray
  bool is_ahead;
  Summand of;
};

inline BoundaryRay ray_along(const Segment& edge, const IntervalSegment& certified, bool is_ahead,
                             Summand of) {
  return {&edge,
          is_ahead ? certified.target - certified.source : certified.source - certified.target,
          is_ahead, of};
}

/// As is_sector_inside_both, for rays in any order, those of the two summands each on its own. Sorts them.
bool interiors_meet_around(std::span<BoundaryRay> rays);

}  // namespace oplus
