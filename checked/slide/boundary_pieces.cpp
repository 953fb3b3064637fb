// SPDX-License-Identifier: MIT
#include "checked/slide/boundary_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "checked/slide/point_grid.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

namespace {

void sort_along(const BoundaryPiece& piece, const std::function<Point(std::uint32_t)>& exact,
                ShortList<std::uint32_t>& inside) {
  std::sort(inside.begin(), inside.end(),
            [&](std::uint32_t a, std::uint32_t b) { return exact(a) < exact(b); });
  if (exact(piece.to) < exact(piece.from)) std::reverse(inside.begin(), inside.end());
}

}  // namespace

std::vector<BoundaryPiece> cut_at_points(const std::vector<BoundaryPiece>& pieces,
                                         const BoundaryPoints& points) {
  const std::vector<double>& near_x = points.near_x;
  const std::vector<double>& near_y = points.near_y;
  const double margin = points.margin;
  constexpr std::size_t few_points = 32;  // comparing all of them is faster than a grid
  std::optional<PointGrid> grid;
  if (near_x.size() > few_points) grid.emplace(near_x, near_y, margin);
  std::vector<BoundaryPiece> result;
  result.reserve(pieces.size());
  ShortList<std::uint32_t> inside;
  for (const BoundaryPiece& piece : pieces) {
    const double ax = near_x[piece.from], ay = near_y[piece.from];
    const double dx = near_x[piece.to] - ax, dy = near_y[piece.to] - ay;
    const double off = 4 * margin * (std::abs(dx) + std::abs(dy) + 4 * margin);
    inside.clear();
    const auto add_if_inside = [&](std::uint32_t i) {
      if (i == piece.from || i == piece.to ||
          OPLUS_MUTANT("slide-pieces-stay-uncut",
                       "free pieces are not cut where others end inside them"))
        return;
      const double x = near_x[i] - ax, y = near_y[i] - ay;
      if (std::abs(dx * y - dy * x) > off) return;
      // Behind one end or the other.
      if (dx * x + dy * y < -off || dx * (x - dx) + dy * (y - dy) > off) return;
      if (points.is_on(i, piece)) inside.push_back(i);
    };
    if (grid) {
      grid->each_near_segment(piece.from, piece.to, add_if_inside);
    } else {
      const double low_x = ax + std::min(dx, 0.0) - 4 * margin,
                   high_x = low_x + std::abs(dx) + 8 * margin;
      const double low_y = ay + std::min(dy, 0.0) - 4 * margin,
                   high_y = low_y + std::abs(dy) + 8 * margin;
      for (std::uint32_t i = 0; i < near_x.size(); ++i) {
        const double x = near_x[i], y = near_y[i];
        // One jump that is rarely taken.
        if ((x >= low_x) & (x <= high_x) & (y >= low_y) & (y <= high_y) & (i != piece.from) &
            (i != piece.to))
          add_if_inside(i);
      }
    }
    if (inside.size() > 1) sort_along(piece, points.exact, inside);
    std::uint32_t from = piece.from;
    for (const std::uint32_t i : inside) {
      result.push_back({from, i, piece.segment});
      from = i;
    }
    result.push_back({from, piece.to, piece.segment});
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace oplus::slide
