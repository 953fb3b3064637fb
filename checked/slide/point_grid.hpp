// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "checked/slide/short_list.hpp"

namespace oplus::slide {

/// Points, given in doubles off by at most `margin`, in about as many equal cells as there are points.
class PointGrid {
 public:
  PointGrid(const std::vector<double>& near_x, const std::vector<double>& near_y, double margin);

  /// Visits the points in the cells that the segment between two points runs through: all those that
  /// are on it, and some that are not.
  template <typename Visit>
  void each_near_segment(std::uint32_t a, std::uint32_t b, const Visit& visit) const {
    if (near_x_[b] < near_x_[a]) std::swap(a, b);
    const double ax = near_x_[a], ay = near_y_[a], bx = near_x_[b], by = near_y_[b];
    // Both the points and the ends may be off.
    const double low = std::min(ay, by) - 2 * margin_, high = std::max(ay, by) + 2 * margin_;
    const std::size_t last_column = columns_.of(bx + 2 * margin_);
    const bool is_steep = bx - ax < 0x1p10 * margin_;
    const double slope = is_steep ? 0 : (by - ay) / (bx - ax);
    const double around = 8 * margin_ * (1 + std::abs(slope));
    for (std::size_t column = columns_.of(ax - 2 * margin_); column <= last_column; ++column) {
      double from = low, to = high;
      if (!is_steep) {
        // Where the segment enters and leaves the column.
        const double enters = ay + slope * (std::max(columns_.begin(column), ax) - ax);
        const double leaves = ay + slope * (std::min(columns_.begin(column + 1), bx) - ax);
        from = std::max(low, std::min(enters, leaves) - around);
        to = std::min(high, std::max(enters, leaves) + around);
      }
      const std::size_t first = column * rows_.count;
      for (std::size_t k = first_[first + rows_.of(from)]; k < first_[first + rows_.of(to) + 1];
           ++k)
        visit(points_[k]);
    }
  }

 private:
  /// Equal parts of a range; what is outside belongs to the first or the last.
  struct Parts {
    double low;
    double size;
    std::size_t count;

    std::size_t of(double c) const {
      const double part = (c - low) / size;
      return part <= 0 ? 0 : std::min(static_cast<std::size_t>(part), count - 1);
    }
    double begin(std::size_t part) const { return low + size * static_cast<double>(part); }
  };
  static Parts parts(const std::vector<double>& coordinates, std::size_t count);

  const std::vector<double>& near_x_;
  const std::vector<double>& near_y_;
  double margin_;
  Parts columns_;
  Parts rows_;
  ShortList<std::uint32_t> first_;  ///< of each cell, column by column, in `points_`
  ShortList<std::uint32_t> points_;
};

}  // namespace oplus::slide
