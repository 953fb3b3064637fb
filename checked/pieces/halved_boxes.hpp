// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "checked/pieces/halving_order.hpp"

namespace oplus::pieces {

struct Box {
  double x_low = std::numeric_limits<double>::infinity(), x_high = -x_low;
  double y_low = x_low, y_high = x_high;

  void add(const Box& other) {
    x_low = std::min(x_low, other.x_low);
    x_high = std::max(x_high, other.x_high);
    y_low = std::min(y_low, other.y_low);
    y_high = std::max(y_high, other.y_high);
  }
  double size() const { return (x_high - x_low) + (y_high - y_low); }
};

/// Boxes around the halves of a list, the halves of these, and so on; the list is in an order such as
/// halving_order's.
class HalvedBoxes {
 public:
  explicit HalvedBoxes(const std::vector<Box>& list) : nodes_(2 * list.size()) {
    if (!list.empty()) build(list, {0, static_cast<std::uint32_t>(list.size()), 0});
  }

  /// Some of the list, with the first of their boxes: one around all, then those of either half.
  struct Range {
    std::uint32_t begin, end;
    std::uint32_t box;

    bool is_one() const { return end - begin == 1; }
    std::pair<Range, Range> halves() const {
      const auto middle = begin + static_cast<std::uint32_t>(first_half(end - begin));
      return {{begin, middle, box + 1}, {middle, end, box + 2 * (middle - begin)}};
    }
  };
  bool empty() const { return nodes_.empty(); }
  /// Requires: it is not empty.
  Range all() const { return {0, static_cast<std::uint32_t>(nodes_.size() / 2), 0}; }
  const Box& operator[](const Range& range) const { return nodes_[range.box].box; }
  /// By how much the box is larger than those around the things of the list in it, on average.
  double slack(const Range& range) const { return nodes_[range.box].slack; }

 private:
  struct Node {
    Box box;
    double slack = 0;
  };

  /// Returns the size of all in the list, added up.
  double build(const std::vector<Box>& list, const Range& range) {
    Node& node = nodes_[range.box];
    if (range.is_one()) {
      node.box = list[range.begin];
      return node.box.size();
    }
    const auto [first, second] = range.halves();
    const double sizes = build(list, first) + build(list, second);
    node.box = nodes_[first.box].box;
    node.box.add(nodes_[second.box].box);
    node.slack = node.box.size() - sizes / (range.end - range.begin);
    return sizes;
  }

  std::vector<Node> nodes_;
};

}  // namespace oplus::pieces
