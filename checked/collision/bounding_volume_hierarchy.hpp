// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "checked/arithmetic/interval.hpp"

namespace oplus {

struct Box {
  Interval x;
  Interval y;

  bool meets(const Box& other) const { return x.do_overlap(other.x) && y.do_overlap(other.y); }
};

inline Box operator+(const Box& box, const IntervalPoint& by) {
  return {box.x + by.x, box.y + by.y};
}

/// A binary tree of axis-aligned boxes around segments: each node's segments are halved by the
/// middles of their boxes along the longer side (thesis, Section 5.1.2).
class BoundingVolumeHierarchy {
 public:
  explicit BoundingVolumeHierarchy(const std::vector<Segment>& segments);

  bool empty() const { return nodes_.empty(); }

  /// Calls `visit(i, j)` for segment i of this hierarchy and segment j of `moved` wherever their
  /// boxes meet, `moved` translated by `by`, until a call returns true. Returns whether one did.
  /// Requires: Protect_FPU_rounding, as for Interval.
  template <typename Visit>
  bool visit_meeting(const BoundingVolumeHierarchy& moved, const IntervalPoint& by,
                     Visit&& visit) const {
    if (empty() || moved.empty()) return false;
    std::vector<std::pair<std::size_t, std::size_t>> pending{{0, 0}};
    while (!pending.empty()) {
      const auto [a, b] = pending.back();
      pending.pop_back();
      const Node& node = nodes_[a];
      const Node& other = moved.nodes_[b];
      if (!node.box.meets(other.box + by)) continue;
      if (node.is_leaf() && other.is_leaf()) {
        if (visit(node.segment, other.segment)) return true;
        continue;
      }
      const auto each_child = [](const Node& parent, std::size_t self, auto&& action) {
        if (parent.is_leaf()) return action(self);
        action(self + 1);
        action(parent.right);
      };
      each_child(node, a, [&](std::size_t child) {
        each_child(other, b, [&](std::size_t child_of_other) {
          pending.emplace_back(child, child_of_other);
        });
      });
    }
    return false;
  }

 private:
  /// The left child follows its parent directly.
  struct Node {
    Box box;
    std::size_t right = 0;    ///< the right child; 0 in a leaf
    std::size_t segment = 0;  ///< in a leaf
    bool is_leaf() const { return right == 0; }
  };

  void build(std::vector<std::pair<Box, std::size_t>>& boxes, std::size_t begin, std::size_t end);

  std::vector<Node> nodes_;
};

}  // namespace oplus
