// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "checked/distance/nearest_points.hpp"

namespace oplus {

// All require: regions are valid (validity.hpp); they may be unbounded. Exact. Threads: any.

/// Returns the squared distance of two closed regions, and a pair of points that are as near as that. Requires:
/// neither is empty. Cost: for n and m edges O(n log n + m log m) and, by experience, little more; O(nm) at worst.
NearestPoints distance(const Region& p, const Region& q);

/// Returns a shortest move of Q after which the interiors of P and Q don't meet: the point of the complement of
/// their no-fit polygon that is nearest to the origin, exact fits included. Returns none where the interiors
/// don't meet as they are. Throws InvalidInput where they meet after all moves. Cost: at most that of the no-fit
/// polygon; much less where the overlap is not deep.
std::optional<Overlap> depth(const Region& p, const Region& q);

}  // namespace oplus
