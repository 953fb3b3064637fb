// SPDX-License-Identifier: MIT
#include "checked/slide/boundary_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "checked/slide/parallel_for.hpp"
#include "checked/slide/point_grid.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

namespace {

/// Calls add(part) for the parts of a piece, in the order along it.
template <typename Add>
void cut_piece(const BoundaryPiece& piece, const std::optional<PointGrid>& grid,
               const BoundaryPoints& points, ShortList<std::uint32_t>& inside, const Add& add) {
  const std::span<const double> near_x = points.near_x, near_y = points.near_y;
  const double ax = near_x[piece.from], ay = near_y[piece.from];
  const double bx = near_x[piece.to], by = near_y[piece.to];
  const double dx = bx - ax, dy = by - ay;
  const double margin =
      PointGrid::margin(std::max({std::abs(ax), std::abs(ay), std::abs(bx), std::abs(by)}));
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
    // Points are in the order of the plane.
    const auto [first, last] = std::minmax(piece.from, piece.to);
    const double low = std::min(ay, by) - 4 * margin, high = std::max(ay, by) + 4 * margin;
    for (std::uint32_t i = first + 1; i < last; ++i)
      if (near_y[i] >= low && near_y[i] <= high) add_if_inside(i);
  }
  std::sort(inside.begin(), inside.end());
  if (piece.to < piece.from) std::reverse(inside.begin(), inside.end());
  std::uint32_t from = piece.from;
  for (const std::uint32_t i : inside) {
    add({from, i, piece.segment});
    from = i;
  }
  add({from, piece.to, piece.segment});
}

/// Sorted, by counting how many leave each point.
std::vector<BoundaryPiece> sorted(std::span<const BoundaryPiece> pieces, std::size_t points) {
  ShortList<std::uint32_t> first(points + 1, 0);
  for (const BoundaryPiece& piece : pieces) ++first[piece.from + 1];
  for (std::size_t i = 0; i < points; ++i) first[i + 1] += first[i];
  ShortList<std::uint32_t> next(first.begin(), first.end() - 1);
  std::vector<BoundaryPiece> result(pieces.size());
  for (const BoundaryPiece& piece : pieces) result[next[piece.from]++] = piece;
  for (std::size_t i = 0; i < points; ++i)
    if (first[i + 1] - first[i] > 1)
      std::sort(result.begin() + first[i], result.begin() + first[i + 1]);
  return result;
}

}  // namespace

std::vector<BoundaryPiece> cut_at_points(std::span<const BoundaryPiece> pieces,
                                         const BoundaryPoints& points, unsigned threads) {
  constexpr std::size_t few_points = 32;  // comparing all of them is faster than a grid
  std::optional<PointGrid> grid;
  if (points.near_x.size() > few_points) grid.emplace(points.near_x, points.near_y);
  // Most pieces stay whole: parts behind the first one come after all pieces.
  ShortList<BoundaryPiece> cut(pieces.begin(), pieces.end()), others;
  std::mutex mutex;
  for_each_part(pieces.size(), threads, [&](std::size_t first, std::size_t last) {
    ShortList<std::uint32_t> inside;
    ShortList<BoundaryPiece> found;
    for (std::size_t k = first; k < last; ++k)
      cut_piece(pieces[k], grid, points, inside, [&](const BoundaryPiece& part) {
        if (part.from == pieces[k].from)
          cut[k] = part;
        else
          found.push_back(part);
      });
    const std::lock_guard lock(mutex);
    others.insert(others.end(), found.begin(), found.end());
  });
  cut.insert(cut.end(), others.begin(), others.end());
  return sorted(span_of(cut), points.near_x.size());
}

}  // namespace oplus::slide
