// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// Straight paths across the whole sum, from outside to outside, each cut wherever it meets the
/// vertex-edge sum. Some run through points of it and along its segments: those are the paths on
/// which something can go wrong.
std::vector<std::vector<Segment>> paths_across(const Summands& summands);

}  // namespace oplus
