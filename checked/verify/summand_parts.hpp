// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "checked/boxes/box_tree.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/region.hpp"

namespace oplus::convex_parts {

struct Corner {
  Point point;
  IntervalPoint near;
};

/// The line of an edge, or a diagonal.
struct Line {
  const Corner* from;
  const Corner* to;
  IntervalPoint near_along;
  int rank = 0;

  Vector along() const { return to->point - from->point; }
  bool ends_at(const Corner* corner) const { return corner == from || corner == to; }
};

/// A side of a convex part, counterclockwise: the part is to its left.
struct Side {
  const Line* line;
  const Corner* start;
  int rank = 0;  ///< of its direction
};

/// A convex part: its sides among those of the summand.
struct Piece {
  std::uint32_t first;
  std::uint32_t count;
};

/// A summand in the form in which its parts are added: convex pieces (convex_pieces.hpp), and boxes around them.
struct SummandParts {
  /// Requires: the region is valid (validity.hpp).
  explicit SummandParts(const Region& region);
  SummandParts(const SummandParts&) = delete;  // it points into itself
  SummandParts& operator=(const SummandParts&) = delete;

  std::vector<Corner> corners;      ///< the sources of the edges,
  std::vector<std::size_t> before;  ///< of each edge, the one that ends where it starts,
  std::vector<std::size_t> after;   ///< and the one that starts where it ends
  std::vector<Line> lines;          ///< of the edges, and then of diagonals
  std::vector<Side> sides;
  std::vector<Piece> pieces;
  BoxTree<> boxes;  ///< of the pieces
};

}  // namespace oplus::convex_parts
