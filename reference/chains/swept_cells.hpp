// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/cells.hpp"

namespace oplus {

/// What cut_at_intersections returns, by a sweep: O((n + k) log n) for n segments and k pieces. A segment
/// without length has no pieces, but cuts others.
std::vector<std::vector<Segment>> swept_pieces(const std::vector<Segment>& segments);

}  // namespace oplus
