// SPDX-License-Identifier: MIT
#include "checked/slide/point_grid.hpp"

#include <numeric>

namespace oplus::slide {

PointGrid::Parts PointGrid::parts(std::span<const std::uint32_t> points,
                                  std::span<const double> coordinates, std::size_t count) {
  if (points.empty()) return {};
  double low = coordinates[points[0]], high = low;
  for (const std::uint32_t i : points) {
    low = std::min(low, coordinates[i]);
    high = std::max(high, coordinates[i]);
  }
  const double size = (high - low) / static_cast<double>(count);
  return size > 0 ? Parts{low, size, count} : Parts{low, 1, 1};
}

PointGrid::PointGrid(std::span<const double> near_x, std::span<const double> near_y)
    : near_x_(near_x), near_y_(near_y) {
  ShortList<std::uint32_t> all(near_x.size());
  std::iota(all.begin(), all.end(), 0);
  cells_ = cells_of({all.data(), all.size()});
}

PointGrid::Cells PointGrid::cells_of(std::span<const std::uint32_t> points) const {
  constexpr std::size_t many = 64;
  Cells cells;
  const auto count = static_cast<std::size_t>(std::ceil(std::sqrt(points.size() + 1)));
  Parts& columns = cells.columns = parts(points, near_x_, count);
  Parts& rows = cells.rows = parts(points, near_y_, count);
  cells.margin = margin(std::max(
      {std::abs(columns.low), std::abs(columns.end()), std::abs(rows.low), std::abs(rows.end())}));
  const auto cell_of = [&](std::uint32_t i) {
    return columns.of(near_x_[i]) * rows.count + rows.of(near_y_[i]);
  };
  ShortList<std::uint32_t>& first = cells.first;
  first.assign(columns.count * rows.count + 1, 0);
  for (const std::uint32_t i : points) ++first[cell_of(i) + 1];
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  cells.points.resize(points.size());
  ShortList<std::uint32_t> next(first.begin(), first.end() - 1);
  for (const std::uint32_t i : points) cells.points[next[cell_of(i)]++] = i;
  // Each grid has points in two opposite rows or columns, so a cell has fewer than the whole, unless all
  // points are equal in doubles.
  for (std::size_t cell = 0; columns.count * rows.count > 1 && cell + 1 < first.size(); ++cell) {
    const std::size_t size = first[cell + 1] - first[cell];
    if (size <= many) continue;
    cells.in_cell.resize(first.size() - 1);
    cells.in_cell[cell] =
        std::make_unique<Cells>(cells_of({cells.points.data() + first[cell], size}));
  }
  return cells;
}

}  // namespace oplus::slide
