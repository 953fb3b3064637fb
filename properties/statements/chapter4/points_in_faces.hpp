// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// Returns a point in every face of the segments' arrangement, one for each connected part of the
/// face's boundary. None is on a segment, nor on one of `avoided`.
std::vector<Point> points_in_faces(const std::vector<Segment>& segments,
                                   const std::vector<Segment>& avoided);

/// Placements x of -Q in general position, at least one in each face of the arrangement of 𝒞 ∪ 𝒞′:
/// on no segment of the vertex-edge sum, so that no vertex of P or -Q+x is on the other's boundary.
std::vector<Point> generic_placements(const Summands& summands);

}  // namespace oplus
