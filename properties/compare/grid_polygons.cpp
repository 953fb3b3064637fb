// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/grid_polygons.hpp"

#include <algorithm>
#include <array>

#include "reference/chains/validity.hpp"

namespace oplus {

namespace {

bool is_less(const GridPolygon& a, const GridPolygon& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

int twice_area(const GridPolygon& polygon) {
  int sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LatticePoint& a = polygon[i];
    const LatticePoint& b = polygon[next(i, polygon.size())];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

bool touches_axes(const GridPolygon& polygon) {
  return std::ranges::count(polygon, 0, &LatticePoint::x) > 0 &&
         std::ranges::count(polygon, 0, &LatticePoint::y) > 0;
}

/// Adds all polygons that begin with the given vertices, the first of which is the smallest.
void extend(GridPolygon& begun, int side, std::size_t most, std::vector<GridPolygon>& all) {
  if (begun.size() >= 3 && twice_area(begun) > 0 && touches_axes(begun) &&
      !find_defect(region_of(begun)))
    all.push_back(begun);
  if (begun.size() == most) return;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      const LatticePoint p{x, y};
      if (p <= begun[0] || std::ranges::count(begun, p) > 0) continue;
      begun.push_back(p);
      extend(begun, side, most, all);
      begun.pop_back();
    }
  }
}

}  // namespace

Region region_of(const GridPolygon& polygon) {
  Chain chain;
  for (const LatticePoint& p : polygon) chain.push_back({p.x, p.y});
  return oplus::polygon(std::move(chain));
}

std::vector<GridPolygon> grid_polygons(int side, std::size_t most) {
  std::vector<GridPolygon> all;
  for (int y = 0; y < side; ++y) {
    GridPolygon begun = {{0, y}};  // the smallest vertex has the least x
    extend(begun, side, most, all);
  }
  std::ranges::sort(all, is_less);
  return all;
}

GridPolygon image(const GridPolygon& polygon, std::size_t symmetry) {
  GridPolygon result;
  for (LatticePoint p : polygon) {
    if (symmetry & 1U) p.x = -p.x;
    if (symmetry & 2U) p.y = -p.y;
    if (symmetry & 4U) std::swap(p.x, p.y);
    result.push_back(p);
  }
  if (twice_area(result) < 0) std::reverse(result.begin(), result.end());
  LatticePoint low = result[0];
  for (const LatticePoint& p : result) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  for (LatticePoint& p : result) p = {p.x - low.x, p.y - low.y};
  std::rotate(result.begin(), std::ranges::min_element(result), result.end());
  return result;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> pair_orbits(
    const std::vector<GridPolygon>& polygons) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  const auto count = static_cast<std::uint32_t>(polygons.size());
  std::vector<std::array<std::uint32_t, square_symmetries>> images(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::size_t s = 0; s < square_symmetries; ++s)
      images[i][s] = static_cast<std::uint32_t>(
          std::ranges::lower_bound(polygons, image(polygons[i], s), is_less) - polygons.begin());
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = i; j < count; ++j) {
      const std::pair own(i, j);
      bool is_smallest = true;
      for (std::size_t s = 0; s < square_symmetries && is_smallest; ++s)
        is_smallest = std::pair(std::minmax({images[i][s], images[j][s]})) >= own;
      if (is_smallest) pairs.push_back(own);
    }
  }
  return pairs;
}

}  // namespace oplus
