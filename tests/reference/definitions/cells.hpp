// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// The half-integer grid, each of its squares cut into four triangles by its diagonals, so that
/// each of `shapes()`, and any copy of one moved by half-integers, is a union of such cells.
struct Cell {
  int column, row;  ///< the square from (column/2, row/2)
  int side;         ///< the triangle at its right, left, upper or lower side

  friend auto operator<=>(const Cell&, const Cell&) = default;
};

inline Point point_in(const Cell& cell) {
  const std::array<Vector, 4> to_side{Vector{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  const Vector& off = to_side[static_cast<std::size_t>(cell.side)];
  return {(cell.column + Rational(1, 2) + off.x / 4) / 2,
          (cell.row + Rational(1, 2) + off.y / 4) / 2};
}

/// All cells between (low, low) and (high, high).
inline std::vector<Cell> cells(int low, int high) {
  std::vector<Cell> all;
  for (int i = 2 * low; i < 2 * high; ++i)
    for (int j = 2 * low; j < 2 * high; ++j)
      for (int side = 0; side < 4; ++side) all.push_back({i, j, side});
  return all;
}

/// Whether a point on no edge is inside, told by nothing but the parity of the edges above it.
inline bool is_inside(const Point& p, const std::vector<Segment>& boundary) {
  bool odd = false;
  for (const Segment& e : boundary) {
    if ((e.source.x < p.x) == (e.target.x < p.x)) continue;
    const Rational t = (p.x - e.source.x) / (e.target.x - e.source.x);
    if (e.source.y + t * (e.target.y - e.source.y) > p.y) odd = !odd;
  }
  return odd;
}

/// The cells of one of the `shapes()`, or of its reflection: coordinates from -8 to 8.
inline std::set<Cell> cells_of(const Region& region) {
  std::set<Cell> result;
  const std::vector<Segment> boundary = edges(region);
  for (const Cell& cell : cells(-8, 8))
    if (is_inside(point_in(cell), boundary)) result.insert(cell);
  return result;
}

/// Whether a and b have a cell in common, b moved by (columns/2, rows/2): whether their interiors
/// meet.
inline bool share_a_cell(const std::set<Cell>& a, const std::set<Cell>& b, int columns, int rows) {
  for (const Cell& cell : b)
    if (a.contains({cell.column + columns, cell.row + rows, cell.side})) return true;
  return false;
}

}  // namespace oplus
