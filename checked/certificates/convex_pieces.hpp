// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "checked/certificates/triangulation.hpp"

namespace oplus::certificates {

/// The numbers of its corners, counterclockwise; inner angles are at most π. One side at most has more than
/// one flat corner. Triangles between the first corner and two that follow each other are counterclockwise.
using ConvexPiece = std::vector<std::uint32_t>;

/// A region as the union of convex pieces whose interiors are disjoint. Their edges are, as a multiset,
/// those of the region, cut at `points`, and diagonals in both directions.
struct ConvexPieces {
  std::vector<Point> vertices;  ///< of the region, in the order of `chains`
  std::vector<PointInEdge> points;
  std::vector<ConvexPiece> pieces;  ///< near one another where their numbers are
};

/// The constrained Delaunay triangulation without the diagonals that are not needed, the longest ones
/// removed first (Hertel and Mehlhorn). A piece has at most so many corners. O(n log n) in practice.
/// Requires: as for `triangulation`; most_corners >= 3.
ConvexPieces convex_pieces(const Region& region, std::uint32_t most_corners);

}  // namespace oplus::certificates
