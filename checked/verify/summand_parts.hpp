// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "checked/verify/trapezoids.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/region.hpp"

namespace oplus::convex_parts {

/// What is not an integer below 2^23 is computed with relative errors of less than this.
inline constexpr double rounding = 0x1p-50;

/// A number of which a double is known and how far it may be away.
struct Near {
  double value = 0;
  double error = 0;
};

struct NearPoint {
  Near x;
  Near y;
};

/// The line of an edge, or a wall: up through a vertex.
struct Line {
  const Point* from;
  Vector along;
  NearPoint near_from;
  NearPoint near_along;
  int rank = 0;
};

struct Corner {
  Point point;
  NearPoint near;
  bool is_small;  ///< an integer below 2^23
};

/// A side of a convex part, counterclockwise: the part is to its left.
struct Side {
  const Line* line;  ///< of an edge, or a wall, which may be a point
  const Corner* start;
  int turned = 0;  ///< how far its direction is turned from that of the left wall, in ranks
};

/// A convex part: its sides among those of the summand. First the left wall, down; in the middle the
/// right one.
struct Piece {
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t right_wall;
};

struct Box {
  double x_low = std::numeric_limits<double>::infinity(), x_high = -x_low;
  double y_low = x_low, y_high = x_high;

  void add(const Corner& corner) {
    const auto& [x, y] = corner.near;
    x_low = std::min(x_low, x.value - x.error - std::abs(x.value) * rounding);
    x_high = std::max(x_high, x.value + x.error + std::abs(x.value) * rounding);
    y_low = std::min(y_low, y.value - y.error - std::abs(y.value) * rounding);
    y_high = std::max(y_high, y.value + y.error + std::abs(y.value) * rounding);
  }
  void add(const Box& other) {
    x_low = std::min(x_low, other.x_low);
    x_high = std::max(x_high, other.x_high);
    y_low = std::min(y_low, other.y_low);
    y_high = std::max(y_high, other.y_high);
  }
  double size() const { return (x_high - x_low) + (y_high - y_low); }
};

/// The left child follows its parent directly.
struct Node {
  Box box;
  std::uint32_t right = 0;  ///< the right child; 0 in a leaf
  std::uint32_t piece = 0;  ///< in a leaf
  double slack = 0;         ///< by how much it is larger than its pieces, on average
};

/// A summand in the form in which its parts are added: convex parts, of trapezoids that are joined from
/// left to right as long as what they form is convex, and a tree of boxes around them.
struct SummandParts {
  /// Requires: the region is valid (validity.hpp).
  explicit SummandParts(const Region& region);

  std::vector<Segment> edges;
  std::vector<std::size_t> before;         ///< of each edge, the one that ends where it starts,
  std::vector<std::size_t> after;          ///< and the one that starts where it ends
  std::vector<Line> lines;                 ///< of the edges
  std::vector<Line> walls;                 ///< through their sources
  std::vector<Corner> corners;             ///< their sources,
  std::vector<IntervalPoint> near_points;  ///< and intervals around these
  std::vector<Corner> cut_corners;         ///< of walls, where there is no vertex
  std::vector<Side> sides;
  std::vector<Piece> pieces;
  std::vector<Box> boxes;   ///< of the pieces
  std::vector<Node> nodes;  ///< the root first; empty if there are no pieces

 private:
  void add_pieces(const std::vector<Trapezoid>& trapezoids);
  const Corner* at(std::size_t edge, std::size_t vertex);
  void build(std::vector<std::uint32_t>::iterator begin, std::vector<std::uint32_t>::iterator end);
};

}  // namespace oplus::convex_parts
