// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "checked/repair/mend.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// The closure of the points that chains wind around, all together, as the rule says. Nothing is required of
/// them: they may cross, overlap, and repeat vertices. O((n + k) log n) for n edges and k pairs that meet.
PlanarSet filled(const std::vector<Chain>& chains, FillRule rule);

}  // namespace oplus
