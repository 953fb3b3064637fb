// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Returns the least t > 0 at which start + t·along is on one of the segments, which may be points;
/// empty if the ray meets no segment. Requires: the direction is not zero.
std::optional<Rational> first_met(const Point& start, const Vector& along,
                                  const std::vector<Segment>& segments);

/// Returns a point off `start` along a direction, before the ray meets a segment: half way there,
/// or start + along if it meets none sooner than at twice that.
/// Requires: the direction is not zero.
Point point_beside(const Point& start, const Vector& along, const std::vector<Segment>& segments);

}  // namespace oplus
