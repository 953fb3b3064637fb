// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "checked/pieces/balanced_pieces.hpp"
#include "checked/pieces/triangulation.hpp"

namespace oplus::pieces {

/// A region as the union of convex pieces whose interiors are disjoint. Their edges are, as a multiset,
/// those of the region, cut at `points`, and diagonals in both directions.
struct ConvexPieces {
  std::vector<Point> vertices;  ///< of the region, in the order of `chains`
  std::vector<PointInEdge> points;
  std::vector<ConvexPiece> pieces;  ///< near one another where their numbers are
};

/// The constrained Delaunay triangulation (triangulation.hpp) without the diagonals that are not needed, the longest ones
/// removed first (Hertel and Mehlhorn); large convex parts are divided evenly (balanced_pieces.hpp). A piece has at most so many corners. O(n log n) in practice.
/// Requires: no two edges cross or overlap, each has the region to its left only, none is a point;
/// most_corners >= 3.
ConvexPieces convex_pieces(const Region& region, std::uint32_t most_corners = ~std::uint32_t{0});

}  // namespace oplus::pieces
