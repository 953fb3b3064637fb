// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// Straight paths that cross the whole sum, each cut wherever it meets the vertex-edge sum. Some
/// run through ends of its segments and along segments: those are the difficult ones.
std::vector<std::vector<Segment>> paths_across(const Summands& summands);

}  // namespace oplus
