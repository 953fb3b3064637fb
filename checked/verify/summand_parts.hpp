// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

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

/// A trapezoid, with its interior to the left of `below` and of `above`.
struct Piece {
  const Line* below;
  const Line* above;
  const Line* left;  ///< the walls,
  const Line* right;
  const Corner* on_left;  ///< and the vertices that they pass through
  const Corner* on_right;
  std::array<const Corner*, 2> lower;  ///< on the left wall and on the right one
  std::array<const Corner*, 2> upper;
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

/// A summand in the form in which its parts are added: trapezoids, and a tree of boxes around them.
struct SummandParts {
  /// Requires: the region is valid (validity.hpp).
  explicit SummandParts(const Region& region);

  std::vector<Segment> edges;
  std::vector<std::size_t> before;  ///< of each edge, the one that ends where it starts,
  std::vector<std::size_t> after;   ///< and the one that starts where it ends
  std::vector<Line> lines;          ///< of the edges
  std::vector<Line> walls;          ///< through their sources
  std::vector<Corner> corners;      ///< their sources
  std::vector<Corner> cut_corners;  ///< of trapezoids, where there is no vertex
  std::vector<Piece> pieces;
  std::vector<Box> boxes;   ///< of the pieces
  std::vector<Node> nodes;  ///< the root first; empty if there are no pieces

 private:
  const Corner* at(std::size_t edge, std::size_t vertex);
  void build(std::vector<std::uint32_t>::iterator begin, std::vector<std::uint32_t>::iterator end);
};

}  // namespace oplus::convex_parts
