// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// A point of the face to the left of a segment, whose boundary is among `edges`; on none of these,
/// and none of `avoided`.
Point point_left_of(const Segment& segment, const std::vector<Segment>& edges,
                    const std::vector<Segment>& avoided);

/// The same for a bounded face by its boundary, the face to the left: a point with few decimals, if
/// one is found.
Point point_of_face(const std::vector<Segment>& boundary, const std::vector<Segment>& avoided);

}  // namespace oplus
