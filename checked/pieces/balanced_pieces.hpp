// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "checked/pieces/place.hpp"

namespace oplus::pieces {

/// The numbers of its corners, counterclockwise; inner angles are at most π. One side at most has more than
/// one flat corner. Triangles between the first corner and two that follow each other are counterclockwise.
using ConvexPiece = std::vector<std::uint32_t>;

/// A convex polygon, of which one side at most has more than one flat corner.
struct ConvexRing {
  std::vector<std::uint32_t> corners;  ///< counterclockwise
  std::vector<bool> is_flat;           ///< of each corner
};

/// Divides a convex polygon by diagonals into pieces with at most so many corners, nearly as few as there can be: into slabs
/// across its longer side, and these into pieces whose other sides are those of caps, which are divided likewise. So boxes
/// around pieces overlap little, which they do not in a fan. O(n log n).
/// Requires: most_corners >= 3.
void add_balanced_pieces(ConvexRing ring, std::uint32_t most_corners, std::span<const Place> places,
                         std::vector<ConvexPiece>& pieces);

}  // namespace oplus::pieces
