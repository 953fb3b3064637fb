// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <experimental/simd>
#include <span>
#include <vector>

namespace oplus::slide {

/// Axis-parallel, around what it stands for: the smallest x and y, then the negated largest ones. So
/// the sum of two boxes is the sum of these numbers, and a point is in a box where each of them is at
/// most that of the point.
using Box = std::experimental::simd<float, std::experimental::simd_abi::deduce_t<float, 4>>;

inline Box box_of(float low_x, float low_y, float minus_high_x, float minus_high_y) {
  const float numbers[] = {low_x, low_y, minus_high_x, minus_high_y};
  return Box(numbers, std::experimental::element_aligned);
}

/// The smallest box with such numbers around two points.
Box box_around(double ax, double ay, double bx, double by);

/// The smallest box around two.
inline Box around(const Box& a, const Box& b) { return std::experimental::min(a, b); }

/// Whether a point, or a box that is given by its smallest and largest coordinates the other way
/// round, has something in common with a box.
[[gnu::always_inline]] inline bool contains(const Box& box, const Box& point) {
  return std::experimental::all_of(box <= point);
}

/// A point in doubles, off by less than `error`.
struct NearPoint {
  double x, y;
  double error = 0;

  /// For contains(): a sum of boxes in which the point is contains it, since rounding to the nearest
  /// float changes no order.
  Box box() const {
    return box_of(static_cast<float>(x + error), static_cast<float>(y + error),
                  static_cast<float>(error - x), static_cast<float>(error - y));
  }
};

/// A segment in doubles, each off by at most a rounding.
struct NearSegment {
  double x, y;    ///< of the source
  double dx, dy;  ///< of the direction
};

/// The points v with low <= [d, v] <= high, where [,] is the skew product.
struct Strip {
  double dx, dy;
  double low, high;
};

/// Boxes over the edges of a summand, chain by chain. The root is node 0. The edges of a chain are halved
/// in the order of the boundary, or by the sides of their boxes where that gives smaller boxes.
class BoxTree {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Node {
    Box box;
    std::uint32_t edge;   ///< of a leaf, else none
    std::uint32_t right;  ///< of an inner node, else none; the left child is the next node
    float size;           ///< half the circumference of the box, to choose which node to open
    std::uint32_t strip;  ///< the number of a strip around what the box is around, or none

    bool is_leaf() const { return right == none; }
  };

  BoxTree() = default;  ///< of no boxes

  /// With strips around inner nodes that are much narrower than their boxes, if there are segments. Chains
  /// are given by their first edges, and kept together. Requires: at least one box. O(n log^2 n).
  explicit BoxTree(const std::vector<Box>& of_edges, std::span<const NearSegment> edges = {},
                   std::span<const std::uint32_t> chains = {});

  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  const Strip& strip(std::uint32_t number) const { return strips_[number]; }

 private:
  struct Edges;
  struct Moments;
  struct PartOfBoundary;
  /// Appends a tree over chains.
  Moments add(Edges& edges, std::span<PartOfBoundary> chains);
  /// Appends a tree over a range of the order, which is settled for so many halvings.
  Moments add(Edges& edges, std::uint32_t first, std::uint32_t last, const Box& box,
              unsigned settled);
  /// Adds a strip to a node, if it is narrow.
  template <typename EachEdge>
  Moments with_strip(const Edges& edges, std::size_t node, const Moments& left,
                     const Moments& right, const EachEdge& each_edge);

  std::vector<Node> nodes_;
  std::vector<Strip> strips_;
};

}  // namespace oplus::slide
