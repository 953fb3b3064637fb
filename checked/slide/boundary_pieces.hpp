// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace oplus::slide {

/// A part of a segment of the reduced convolution that is on the boundary of the sum.
struct BoundaryPiece {
  std::uint32_t from;  ///< numbers of points
  std::uint32_t to;
  std::uint32_t segment;

  friend auto operator<=>(const BoundaryPiece&, const BoundaryPiece&) = default;
};

/// Different points, numbered in the order of the plane: in doubles, off by at most 2^-50 of their size.
struct BoundaryPoints {
  /// Exactly; called by several threads.
  std::function<bool(std::uint32_t point, const BoundaryPiece&)> is_on;
  std::span<const double> near_x;
  std::span<const double> near_y;
};

/// Cuts pieces where others end inside them. Sorted. O(n log n) where few cells of the points' grid are
/// on a piece.
std::vector<BoundaryPiece> cut_at_points(std::span<const BoundaryPiece> pieces,
                                         const BoundaryPoints& points, unsigned threads);

}  // namespace oplus::slide
