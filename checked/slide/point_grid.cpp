// SPDX-License-Identifier: MIT
#include "checked/slide/point_grid.hpp"

namespace oplus::slide {

PointGrid::Parts PointGrid::parts(const std::vector<double>& coordinates, std::size_t count) {
  if (coordinates.empty()) return {0, 1, 1};
  const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
  const double size = (*high - *low) / static_cast<double>(count);
  return size > 0 ? Parts{*low, size, count} : Parts{*low, 1, 1};
}

PointGrid::PointGrid(const std::vector<double>& near_x, const std::vector<double>& near_y,
                     double margin)
    : near_x_(near_x), near_y_(near_y), margin_(margin) {
  const auto count = static_cast<std::size_t>(std::ceil(std::sqrt(near_x.size() + 1)));
  columns_ = parts(near_x, count);
  rows_ = parts(near_y, count);
  const auto cell = [&](std::size_t i) {
    return columns_.of(near_x[i]) * rows_.count + rows_.of(near_y[i]);
  };
  first_.assign(columns_.count * rows_.count + 1, 0);
  for (std::size_t i = 0; i < near_x.size(); ++i) ++first_[cell(i) + 1];
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  points_.resize(near_x.size());
  ShortList<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < near_x.size(); ++i) points_[next[cell(i)]++] = i;
}

}  // namespace oplus::slide
