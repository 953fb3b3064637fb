// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/cells.hpp"

namespace oplus {

/// What cut_at_intersections returns, by a sweep: O((n + k) log n) for n segments and k pieces. A segment
/// without length has no pieces, but cuts others.
std::vector<std::vector<Segment>> swept_pieces(const std::vector<Segment>& segments);

/// What cells_of_pieces returns, in O(n log n) for n pieces.
/// Requires: `pieces` as swept_pieces returns them.
Cells swept_cells_of_pieces(const std::vector<std::vector<Segment>>& pieces);

/// What cells returns, in O((n + k) log n) for n segments and k pieces.
Cells swept_cells(const std::vector<Segment>& segments);

}  // namespace oplus
