// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "checked/collision/segment_tree.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

/// A point of the face to the left of a segment, whose boundary is among `edges`; on none of these,
/// and none of `avoided`.
Point point_left_of(const Segment& segment, const std::vector<Segment>& edges,
                    const std::vector<Segment>& avoided);

/// The same for a bounded face by its boundary, the face to the left: a point with few decimals, if
/// one is found.
Point point_of_face(const std::vector<Segment>& boundary, const std::vector<Segment>& avoided);

/// A point near the middle of edge `edge`, to its left or to its right, with few digits, if one is near
/// enough. It is nearer to that edge than to any other, and so on no edge and in a face beside it; and nearer than `room`,
/// beyond which there may be edges that are not given. A second or a third attempt finds other points, with more digits.
/// Requires: edges do not cross. Throws VerdictsDiffer (verdicts_differ.hpp) where others touch the edge in
/// more than points: those of a sum do not.
Point point_near(const SegmentTree& edges, std::size_t edge, bool left, int attempt = 0,
                 double room = SegmentTree::nothing);

}  // namespace oplus
