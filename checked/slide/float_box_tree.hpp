// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "checked/slide/short_list.hpp"

namespace oplus::slide {

/// Axis-parallel, around what it stands for: the smallest x and y, then the negated largest ones. So
/// the sum of two boxes is the sum of these numbers, and a point is in a box where each of them is at
/// most that of the point.
///
/// A vector of the compiler's, whose operators work on all four numbers at once. With plain loops in their
/// place a sum of two stars of 500 vertices takes 1.35 times as long.
typedef float FloatBox __attribute__((vector_size(16)));

inline FloatBox box_of(float low_x, float low_y, float minus_high_x, float minus_high_y) {
  return FloatBox{low_x, low_y, minus_high_x, minus_high_y};
}

/// The smallest box with such numbers around two points.
FloatBox box_around(double ax, double ay, double bx, double by);

/// The smallest box around two.
inline FloatBox around(const FloatBox& a, const FloatBox& b) { return a < b ? a : b; }

/// Whether a point, or a box that is given by its smallest and largest coordinates the other way
/// round, has something in common with a box.
[[gnu::always_inline]] inline bool contains(const FloatBox& box, const FloatBox& point) {
  // Lanes of which all bits are set, or none; as halves they are or-ed in the fewest steps.
  typedef std::int64_t Halves __attribute__((vector_size(16)));
  const Halves outside = reinterpret_cast<Halves>(box > point);
  return (outside[0] | outside[1]) == 0;
}

/// A point in doubles, each off by less than `error`. (NearPoint of near_point.hpp knows its exact point, too.)
struct ApproximatePoint {
  double x, y;
  double error = 0;

  /// For contains(): a sum of boxes in which the point is contains it, since rounding to the nearest
  /// float changes no order.
  FloatBox box() const {
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
class FloatBoxTree {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Node {
    FloatBox box;
    std::uint32_t edge;   ///< of a leaf, else none
    std::uint32_t right;  ///< of an inner node, else none; the left child is the next node
    float size;  ///< at most half the circumference of the box, to choose which node to open
    std::uint32_t strip;  ///< the number of a strip around what the box is around, or none

    bool is_leaf() const { return right == none; }
  };

  FloatBoxTree() = default;  ///< of no boxes

  /// With strips around inner nodes that are much narrower than their boxes, if there are segments. Chains
  /// are given by their first edges, and kept together. Requires: at least one box. O(n log^2 n).
  explicit FloatBoxTree(const std::vector<FloatBox>& of_edges,
                        std::span<const NearSegment> edges = {},
                        std::span<const std::uint32_t> chains = {}, unsigned threads = 1);

  std::size_t size() const { return nodes_.size(); }
  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  const Strip& strip(std::uint32_t number) const { return strips_[number]; }

 private:
  struct Edges;
  struct Moments;
  struct PartOfBoundary;
  /// Appends a tree over chains.
  Moments add(Edges& edges, std::span<PartOfBoundary> chains);
  /// Appends a tree over a range of the order, which is settled for so many halvings.
  Moments add(Edges& edges, std::uint32_t first, std::uint32_t last, const FloatBox& box,
              unsigned settled);
  /// Appends the halves of a node, which add_first() and add_second() append to a tree.
  template <typename First, typename Second>
  std::pair<Moments, Moments> add_halves(const Edges& edges, std::size_t size,
                                         const First& add_first, const Second& add_second);
  /// Adds a strip to a node, if it is narrow.
  template <typename EachEdge>
  Moments with_strip(const Edges& edges, std::size_t node, const Moments& left,
                     const Moments& right, const EachEdge& each_edge);

  std::vector<Node> nodes_;
  std::vector<Strip> strips_;
};

/// Visits the leaves of a tree whose boxes contain a place, as contains() takes it. Stops where a visit
/// returns true; returns whether one did.
template <typename Visit>
bool any_leaf_around(const FloatBoxTree& tree, const FloatBox& place, const Visit& visit) {
  ShortList<std::uint32_t> waiting;
  std::uint32_t node = 0;
  while (true) {
    const FloatBoxTree::Node& here = tree[node];
    if (contains(here.box, place)) {
      if (!here.is_leaf()) {
        waiting.push_back(here.right);
        ++node;
        continue;
      }
      if (visit(here.edge)) return true;
    }
    if (waiting.empty()) return false;
    node = waiting.back();
    waiting.pop_back();
  }
}

}  // namespace oplus::slide
