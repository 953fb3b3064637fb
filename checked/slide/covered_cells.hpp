// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "checked/slide/float_box_tree.hpp"

namespace oplus::slide {

/// The nearest that a part of a segment is to the origin, in doubles.
double near_distance(const NearSegment& s, double from = 0, double to = 1);

/// A square around the origin in 48 x 48 cells. Known of some cells is that each is all inside the open sum: where an
/// edge of P and one of -Q + x cross properly, for all x in the cell. That is where the parallelogram of the two edges
/// contains it. (Not so if the two cross where other chains of both summands touch them: sums of touching points may
/// be anywhere.)
class CoveredCells {
 public:
  /// Takes the edges of both summands; `error` is more than their sums can be off. Cost: a few operations for each pair
  /// of edges; of very many pairs, it looks at none.
  CoveredCells(std::span<const NearSegment> p, std::span<const NearSegment> q, double radius,
               double error);

  /// At most the distance from the origin of what of a segment is in no covered cell; infinite where that is nothing.
  double least_uncovered(const NearSegment& s) const;

 private:
  static constexpr int count = 48;

  double line(int k) const { return k * cell_ - radius_; }
  /// The number of the next line below a place, or above it; that of an outer one beside the square.
  int line_below(double at) const {
    return static_cast<int>(std::clamp((at + radius_) / cell_, 0.0, 1.0 * count));
  }
  int line_above(double at) const {
    const double lines = std::clamp((at + radius_) / cell_, 0.0, 1.0 * count);
    const int below = static_cast<int>(lines);
    return below + (below < lines ? 1 : 0);
  }
  void cover(double x, double y, double ax, double ay, double bx, double by);

  double radius_, cell_, error_;
  std::array<std::uint64_t, count> rows_{};  ///< a bit for each cell
};

}  // namespace oplus::slide
