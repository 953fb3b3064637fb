// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <experimental/simd>
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
inline bool contains(const Box& box, const Box& point) {
  return std::experimental::all_of(box <= point);
}

/// A point in doubles, off by little.
struct NearPoint {
  double x, y;

  /// For contains(): what is not in a box is farther from it than the margin.
  Box box(double margin) const {
    return box_of(static_cast<float>(x + margin), static_cast<float>(y + margin),
                  static_cast<float>(margin - x), static_cast<float>(margin - y));
  }
};

/// Boxes over the edges of a summand, halved in the order of the boundary. The root is node 0.
class BoxTree {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Node {
    Box box;
    std::uint32_t edge;   ///< of a leaf, else none
    std::uint32_t right;  ///< of an inner node, else none; the left child is the next node
    float size;           ///< half the circumference of the box, to choose which node to open

    bool is_leaf() const { return right == none; }
  };

  BoxTree() = default;  ///< of no boxes

  /// Requires: at least one box.
  explicit BoxTree(const std::vector<Box>& of_edges);

  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }

 private:
  void add(const std::vector<Box>& of_edges, std::uint32_t first, std::uint32_t last);

  std::vector<Node> nodes_;
};

}  // namespace oplus::slide
