// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "checked/slide/integer_summand.hpp"

namespace oplus::slide {

/// The components of a summand in boxes: to find those near a place, and whether a place is inside one
/// of them. O(n log n) to build, O(n) in memory.
class ComponentTree {
 public:
  /// Around coordinates in doubles.
  struct NearBox {
    double low_x, low_y, high_x, high_y;

    bool contains(const ApproximatePoint& x, double margin) const {
      return low_x - margin <= x.x && x.x <= high_x + margin && low_y - margin <= x.y &&
             x.y <= high_y + margin;
    }
    double size() const { return (high_x - low_x) + (high_y - low_y); }

    friend NearBox operator+(const NearBox& a, const NearBox& b) {
      return {a.low_x + b.low_x, a.low_y + b.low_y, a.high_x + b.high_x, a.high_y + b.high_y};
    }
  };

  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Node {
    NearBox box;
    /// The edges below a node, if they are a part of one chain. Otherwise `first` is that of `last`;
    /// in a leaf of components() it is the component.
    std::uint32_t first;
    std::uint32_t last;   ///< behind these
    std::uint32_t right;  ///< of an inner node, else none; the left child is the next node

    bool is_leaf() const { return right == none; }
    bool is_part_of_a_chain() const { return first != last; }
  };

  ComponentTree() = default;

  template <typename Numbers>
  explicit ComponentTree(const IntegerSummand<Numbers>& summand)
      : ComponentTree(span_of(summand.near), span_of(summand.chain_of),
                      span_of(summand.first_of_component)) {}

  /// Over the components, halved where they are. The root is node 0.
  const std::vector<Node>& components() const { return components_; }

  /// Whether a ray to the right from near x crosses the chains of a component an odd number of times.
  /// is_above(i) tells exactly whether vertex i is above the ray, crosses(i, next) whether the ray
  /// crosses edge i, which ends at vertex `next`; only parts of chains whose boxes are nearer to x than the margin are
  /// looked into, so it takes O(log n) where chains are not wound around x.
  template <typename IsAbove, typename Crosses>
  bool is_inside(std::uint32_t component, const ApproximatePoint& x, double margin,
                 const IsAbove& is_above, const Crosses& crosses) const {
    return crosses_oddly(chains_of_[component], x, margin, is_above, crosses);
  }

 private:
  ComponentTree(std::span<const NearSegment> near, std::span<const std::uint32_t> chain_of,
                std::span<const std::uint32_t> first_of_component);

  /// Appends a tree over a part of a chain, halved along the chain.
  void add_part(std::span<const NearSegment> near, std::uint32_t first, std::uint32_t last);

  template <typename IsAbove, typename Crosses>
  bool crosses_oddly(std::uint32_t here, const ApproximatePoint& x, double margin,
                     const IsAbove& is_above, const Crosses& crosses) const {
    const Node& node = parts_[here];
    const NearBox& box = node.box;
    if (box.high_x + margin < x.x || box.high_y + margin < x.y || x.y < box.low_y - margin)
      return false;
    if (x.x < box.low_x - margin) {
      // The ray crosses all that is level with it: oddly if the ends are on different sides. Closed
      // chains it crosses evenly.
      return node.is_part_of_a_chain() && is_above(node.first) != is_above(next_[node.last - 1]);
    }
    if (!node.is_leaf())
      return crosses_oddly(here + 1, x, margin, is_above, crosses) !=
             crosses_oddly(node.right, x, margin, is_above, crosses);
    bool oddly = false;
    for (std::uint32_t edge = node.first; edge < node.last; ++edge)
      if (crosses(edge, next_[edge])) oddly = !oddly;
    return oddly;
  }

  std::vector<Node> components_;
  std::vector<Node> parts_;               ///< of chains, and trees over the chains of a component
  std::vector<std::uint32_t> chains_of_;  ///< of each component, the root in `parts_`
  std::vector<std::uint32_t> next_;       ///< of each edge, the next one of its chain
};

}  // namespace oplus::slide
