// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reference/chains/plane_sweep.hpp"
#include "reference/definitions/cells.hpp"

namespace oplus {

/// What cut_at_intersections returns, by a sweep: O((n + k) log n) for n segments and k pieces. A segment
/// without length has no pieces, but cuts others.
std::vector<std::vector<Segment>> swept_pieces(const std::vector<Segment>& segments);

/// What cells returns, in O((n + k) log n) for n segments and k pieces.
Cells swept_cells(const std::vector<Segment>& segments);

/// The same arrangement, all by numbers: those of places are in the order in which `see` is called with them, and faces are
/// numbered as in Cells.
struct NumberedCells {
  /// Of an edge; equal ones, where edges overlap, follow each other.
  struct Piece {
    std::uint32_t from, to;  ///< places, the smaller one first
    std::uint32_t above,
        below;  ///< faces: to the left of the way from the smaller end, and to the right
    std::uint32_t edge;
  };
  std::vector<Piece> pieces;  ///< in the order of `to`
  std::uint32_t face_count = 1;
};
NumberedCells numbered_cells(const SweptEdges& edges,
                             const std::function<void(const SweptPlace&)>& see);

}  // namespace oplus
