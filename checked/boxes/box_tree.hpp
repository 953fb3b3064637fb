// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "checked/boxes/box.hpp"
#include "checked/boxes/halving_order.hpp"

namespace oplus {

/// Boxes around the halves of a list, the halves of these, and so on until `leaf_size` are left, a power of
/// two. The list is in an order such as halving_order's.
template <std::uint32_t leaf_size = 1>
class BoxTree {
 public:
  /// Some of the list, with the first of their nodes: one for all, then those of either half.
  struct Range {
    std::uint32_t begin = 0, end = 0;
    std::uint32_t node = 0;

    std::uint32_t size() const { return end - begin; }
    bool is_leaf() const { return size() <= leaf_size; }
    /// Requires: it is no leaf.
    std::pair<Range, Range> halves() const {
      const std::uint32_t half = first_half(size());
      return {{begin, begin + half, node + 1}, {begin + half, end, node + 2 * half / leaf_size}};
    }
  };

  BoxTree() = default;
  explicit BoxTree(std::span<const Box> list)
      : size_(static_cast<std::uint32_t>(list.size())),
        nodes_(2 * ((list.size() + leaf_size - 1) / leaf_size)) {
    if (!list.empty()) build(list, all());
  }

  bool empty() const { return size_ == 0; }
  /// Requires: it is not empty.
  Range all() const { return {0, size_, 0}; }
  const Box& operator[](const Range& range) const { return nodes_[range.node].box; }
  /// By how much the box is larger than those of the list in it, on average.
  double slack(const Range& range) const { return nodes_[range.node].slack; }

 private:
  struct Node {
    Box box;
    double slack = 0;
  };

  /// Returns the size of all in the list, added up.
  double build(std::span<const Box> list, const Range& range) {
    Node& node = nodes_[range.node];
    double sizes = 0;
    if (range.is_leaf()) {
      for (const Box& box : list.subspan(range.begin, range.size())) {
        node.box = around(node.box, box);
        sizes += box.size();
      }
    } else {
      const auto [first, second] = range.halves();
      sizes = build(list, first) + build(list, second);
      node.box = around(nodes_[first.node].box, nodes_[second.node].box);
    }
    node.slack = node.box.size() - sizes / range.size();
    return sizes;
  }

  std::uint32_t size_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace oplus
