// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Cuts each segment wherever another one meets it, O(n²). Returns the pieces of each in its order
/// and direction; the interiors of any two pieces are disjoint, or they are the same segment up to
/// direction. Membership in the open sum is constant inside a piece, if the segments contain the
/// sum's boundary.
std::vector<std::vector<Segment>> cut_at_intersections(const std::vector<Segment>& segments);

/// Cuts one segment wherever one of the others meets it: its pieces in the order of its direction.
std::vector<Segment> cut_where_met(const Segment& segment, const std::vector<Segment>& others);

}  // namespace oplus
