// SPDX-License-Identifier: MIT
#include "checked/collision/bounding_volume_hierarchy.hpp"

#include <algorithm>
#include <utility>

#include "reference/arithmetic/interval.hpp"

namespace oplus {

namespace {

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

bool meet(const Interval& a, const Interval& b) { return a.low <= b.high && b.low <= a.high; }

/// Where a box goes in the order along an axis; only the shape of the tree depends on it.
double middle(const Interval& side) {
  return std::max(side.low, -DBL_MAX) / 2 + std::min(side.high, DBL_MAX) / 2;
}

}  // namespace

struct BoundingVolumeHierarchy::Box {
  Interval x;
  Interval y;

  bool meets(const Box& other) const { return meet(x, other.x) && meet(y, other.y); }
  Box operator+(const IntervalPoint& by) const { return {x + by.x, y + by.y}; }
  Box with(const Box& other) const { return {hull(x, other.x), hull(y, other.y)}; }
};

/// The left child follows its parent directly.
struct BoundingVolumeHierarchy::Node {
  Box box;
  std::size_t right = 0;    ///< the right child; 0 in a leaf
  std::size_t segment = 0;  ///< in a leaf
  bool is_leaf() const { return right == 0; }
};

struct BoundingVolumeHierarchy::Leaf {
  Box box;
  std::size_t segment;
};

BoundingVolumeHierarchy::BoundingVolumeHierarchy(const std::vector<Segment>& segments) {
  std::vector<Leaf> leaves;
  leaves.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto [source, target] = interval(segments[i]);
    leaves.push_back({{hull(source.x, target.x), hull(source.y, target.y)}, i});
  }
  nodes_.reserve(2 * segments.size());
  if (!leaves.empty()) build(leaves, 0, leaves.size());
}

BoundingVolumeHierarchy::~BoundingVolumeHierarchy() = default;

bool BoundingVolumeHierarchy::empty() const { return nodes_.empty(); }

void BoundingVolumeHierarchy::build(std::vector<Leaf>& leaves, std::size_t begin, std::size_t end) {
  Box around = leaves[begin].box;
  for (std::size_t i = begin + 1; i < end; ++i) around = around.with(leaves[i].box);
  const std::size_t self = nodes_.size();
  nodes_.push_back({around, 0, leaves[begin].segment});
  if (end - begin == 1) return;
  // Where the middles are further apart: long boxes are told apart by their short sides.
  Interval of_x{middle(leaves[begin].box.x), middle(leaves[begin].box.x)};
  Interval of_y{middle(leaves[begin].box.y), middle(leaves[begin].box.y)};
  for (std::size_t i = begin + 1; i < end; ++i) {
    const double x = middle(leaves[i].box.x), y = middle(leaves[i].box.y);
    of_x = hull(of_x, {x, x});
    of_y = hull(of_y, {y, y});
  }
  const bool wide = of_x.high - of_x.low > of_y.high - of_y.low;
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return leaves.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(half), at(end), [&](const Leaf& a, const Leaf& b) {
    return wide ? middle(a.box.x) < middle(b.box.x) : middle(a.box.y) < middle(b.box.y);
  });
  build(leaves, begin, half);
  nodes_[self].right = nodes_.size();
  build(leaves, half, end);
}

bool BoundingVolumeHierarchy::visit_meeting(
    const BoundingVolumeHierarchy& moved, const Vector& by,
    const std::function<bool(std::size_t i, std::size_t j)>& visit) const {
  if (empty() || moved.empty()) return false;
  const IntervalPoint certified_by = interval(by);
  std::vector<std::pair<std::size_t, std::size_t>> pending{{0, 0}};
  while (!pending.empty()) {
    // Not a structured binding: Clang 14 lets no lambda capture one.
    const std::size_t a = pending.back().first;
    const std::size_t b = pending.back().second;
    pending.pop_back();
    const Node& node = nodes_[a];
    const Node& other = moved.nodes_[b];
    if (!node.box.meets(other.box + certified_by)) continue;
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
      each_child(other, b,
                 [&](std::size_t child_of_other) { pending.emplace_back(child, child_of_other); });
    });
  }
  return false;
}

}  // namespace oplus
