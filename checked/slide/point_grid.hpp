// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "checked/slide/short_list.hpp"

namespace oplus::slide {

/// Points, given in doubles off by at most 2^-50 of their size, in about as many equal cells as there
/// are points; where many are in a cell, that cell has such a grid of its own.
class PointGrid {
 public:
  PointGrid(std::span<const double> near_x, std::span<const double> near_y);

  /// Visits the points in the cells that the segment between two points runs through: all those that
  /// are on it, and some that are not.
  template <typename Visit>
  void each_near_segment(std::uint32_t a, std::uint32_t b, const Visit& visit) const {
    if (near_x_[b] < near_x_[a]) std::swap(a, b);
    const double largest = std::max(
        {std::abs(near_x_[a]), std::abs(near_x_[b]), std::abs(near_y_[a]), std::abs(near_y_[b])});
    each_in(cells_, {near_x_[a], near_y_[a], near_x_[b], near_y_[b], margin(largest)}, visit);
  }

  /// By more than this a coordinate and what is computed of it by few operations are not off.
  static double margin(double coordinate) { return std::abs(coordinate) * 0x1p-47; }

 private:
  /// Equal parts of a range; what is outside belongs to the first or the last.
  struct Parts {
    double low = 0;
    double size = 1;
    std::size_t count = 1;

    std::size_t of(double c) const {
      const double part = (c - low) / size;
      return part <= 0 ? 0 : std::min(static_cast<std::size_t>(part), count - 1);
    }
    double end() const { return begin(count); }
    double begin(std::size_t part) const { return low + size * static_cast<double>(part); }
  };

  struct Cells {
    Parts columns;
    Parts rows;
    double margin = 0;               ///< of the borders of cells
    ShortList<std::uint32_t> first;  ///< of each cell, column by column, in `points`
    ShortList<std::uint32_t> points;
    std::vector<std::unique_ptr<Cells>> in_cell;  ///< of each cell with many points; or empty
  };

  struct NearEnds {
    double ax, ay, bx, by;
    double margin;
  };

  static Parts parts(std::span<const std::uint32_t> points, std::span<const double> coordinates,
                     std::size_t count);

  Cells cells_of(std::span<const std::uint32_t> points) const;

  template <typename Visit>
  static void each_in(const Cells& cells, const NearEnds& s, const Visit& visit) {
    const double off = 2 * s.margin + cells.margin;
    if (s.bx < cells.columns.low - off || s.ax > cells.columns.end() + off ||
        std::max(s.ay, s.by) < cells.rows.low - off ||
        std::min(s.ay, s.by) > cells.rows.end() + off)
      return;
    // Both the points and the ends may be off.
    const double low = std::min(s.ay, s.by) - 2 * s.margin;
    const double high = std::max(s.ay, s.by) + 2 * s.margin;
    const std::size_t last_column = cells.columns.of(s.bx + 2 * s.margin);
    const bool is_steep = s.bx - s.ax < 0x1p10 * s.margin;
    const double slope = is_steep ? 0 : (s.by - s.ay) / (s.bx - s.ax);
    const double around = 8 * (s.margin + cells.margin) * (1 + std::abs(slope));
    for (std::size_t column = cells.columns.of(s.ax - 2 * s.margin); column <= last_column;
         ++column) {
      double from = low, to = high;
      if (!is_steep) {
        // Where the segment enters and leaves the column.
        const double enters = s.ay + slope * (std::max(cells.columns.begin(column), s.ax) - s.ax);
        const double leaves =
            s.ay + slope * (std::min(cells.columns.begin(column + 1), s.bx) - s.ax);
        from = std::max(low, std::min(enters, leaves) - around);
        to = std::min(high, std::max(enters, leaves) + around);
      }
      if (from > cells.rows.end() + off || to < cells.rows.low - off) continue;
      const std::size_t column_begin = column * cells.rows.count;
      const std::size_t first = column_begin + cells.rows.of(from);
      const std::size_t last = column_begin + cells.rows.of(to);
      if (cells.in_cell.empty()) {
        for (std::size_t k = cells.first[first]; k < cells.first[last + 1]; ++k)
          visit(cells.points[k]);
        continue;
      }
      for (std::size_t cell = first; cell <= last; ++cell) {
        if (cells.in_cell[cell])
          each_in(*cells.in_cell[cell], s, visit);
        else
          for (std::size_t k = cells.first[cell]; k < cells.first[cell + 1]; ++k)
            visit(cells.points[k]);
      }
    }
  }

  std::span<const double> near_x_;
  std::span<const double> near_y_;
  Cells cells_;
};

}  // namespace oplus::slide
