// SPDX-License-Identifier: MIT
#pragma once

#include "checked/collision/segment_tree.hpp"
#include "checked/distance/nearest_points.hpp"

namespace oplus {

/// Of two lists of segments, those of P and those of Q: the squared distance, and a pair of points that are as near
/// as that. Segments may be points. Exact: bounds in doubles leave few pairs, and rationals decide between these.
/// Requires: neither is empty. By experience little more than O(log n + log m); O(nm) at worst.
NearestPoints nearest_points(const SegmentTree& p, const SegmentTree& q);

}  // namespace oplus
