// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <vector>

#include "reference/definitions/point.hpp"

namespace oplus::slide {

/// A part of a segment of the reduced convolution that is on the boundary of the sum.
struct BoundaryPiece {
  std::uint32_t from;  ///< numbers of points
  std::uint32_t to;
  std::uint32_t segment;

  friend auto operator<=>(const BoundaryPiece&, const BoundaryPiece&) = default;
};

/// Different points: in doubles, off by at most `margin`, and exact on demand.
struct BoundaryPoints {
  std::function<Point(std::uint32_t)> exact;
  std::function<bool(std::uint32_t point, const BoundaryPiece&)> is_on;
  const std::vector<double>& near_x;
  const std::vector<double>& near_y;
  double margin;
};

/// Cuts pieces where others end inside them. Sorted.
std::vector<BoundaryPiece> cut_at_points(const std::vector<BoundaryPiece>& pieces,
                                         const BoundaryPoints& points);

}  // namespace oplus::slide
