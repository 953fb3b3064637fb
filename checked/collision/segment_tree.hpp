// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

/// A box around what certified intervals contain.
struct Box {
  double low_x, low_y, high_x, high_y;
};

Box box_of(const IntervalPoint& p);
Box box_of(const IntervalSegment& s);

/// Around all places that a box is moved to.
inline Box translated(const Box& box, const IntervalPoint& by) {
  const Interval x = outward(box.low_x + by.x.low, box.high_x + by.x.high);
  const Interval y = outward(box.low_y + by.y.low, box.high_y + by.y.high);
  return {x.low, y.low, x.high, y.high};
}

inline bool meet(const Box& a, const Box& b) {
  return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
}

/// At most the squared distance of any two points of the boxes.
double squared_gap(const Box& a, const Box& b);

/// Segments, or points, in a tree of boxes: those near a place, or near those of another tree (thesis,
/// Section 5.1.2), are found without a look at all. Built in O(n log n): each box is halved across the side
/// along which the middles of its segments are furthest apart. Boxes are of certified intervals, so that none is too
/// small.
class SegmentTree {
 public:
  SegmentTree(std::vector<Segment> segments);  // NOLINT(google-explicit-constructor)

  bool empty() const { return segments_.empty(); }
  std::size_t size() const { return segments_.size(); }
  const Segment& operator[](std::size_t i) const { return segments_[i]; }
  const IntervalSegment& certified(std::size_t i) const { return certified_[i]; }

  /// Calls `look(i)` for each segment whose box has a `bound` of at most `limit`, those with small
  /// ones first, as far as the tree knows. `look` returns the limit from then on. The bound of a box
  /// must not be larger than that of a box in it.
  template <typename Bound, typename Look>
  void look_for(double limit, const Bound& bound, const Look& look) const;

  /// Calls `look(i)` for each segment whose box meets another.
  template <typename Look>
  void look_at_meeting(const Box& box, const Look& look) const {
    look_for(
        0, [&](const Box& b) { return meet(b, box) ? 0 : nothing; },
        [&](std::size_t i) {
          look(i);
          return 0;
        });
  }

  /// Calls `visit(i, j)` for segment i of this tree and segment j of `moved` wherever their boxes meet,
  /// `moved` translated by `by`, until a call returns true. Returns whether one did.
  template <typename Visit>
  bool visit_meeting(const SegmentTree& moved, const Vector& by, const Visit& visit) const;

  static constexpr double nothing = std::numeric_limits<double>::infinity();

 private:
  /// The left child follows its parent directly; a leaf has none.
  struct Node {
    Box box;
    std::size_t begin, end;
    std::size_t right = 0;
    bool is_leaf() const { return right == 0; }
  };

  void build(std::size_t begin, std::size_t end);

  std::vector<Segment> segments_;
  std::vector<IntervalSegment> certified_;
  std::vector<Box> boxes_;
  std::vector<std::size_t> order_;  ///< the segments, those of a node together
  std::vector<Node> nodes_;
};

/// Those which may have a point in common with a segment.
std::vector<std::size_t> near(const Segment& segment, const SegmentTree& segments);

/// As the functions of these names for vectors (segment.hpp, cut_at_intersections.hpp,
/// squared_distance.hpp).
bool lies_on_one(const Point& p, const SegmentTree& segments);
std::vector<Segment> cut_where_met(const Segment& segment, const SegmentTree& others);

/// The squared distance from the nearest one, or a number that is not larger than `enough`, where that
/// distance is not. Segment `left_out` does not count. Requires: there is another.
Rational squared_distance(const Point& x, const SegmentTree& segments, const Rational& enough,
                          std::size_t left_out = static_cast<std::size_t>(-1));

/// Bounds of the squared distance of x from a segment.
Interval squared_distance(const IntervalPoint& x, const IntervalSegment& s);

template <typename Bound, typename Look>
void SegmentTree::look_for(double limit, const Bound& bound, const Look& look) const {
  if (nodes_.empty()) return;
  std::array<std::pair<double, std::size_t>, 128> pending;  // halving makes no tree as deep
  std::size_t size = 0;
  pending[size++] = {bound(nodes_[0].box), 0};
  while (size > 0) {
    const auto [least, number] = pending[--size];
    if (least > limit) continue;
    const Node& node = nodes_[number];
    if (node.is_leaf()) {
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (bound(boxes_[order_[i]]) <= limit) limit = look(order_[i]);
      continue;
    }
    std::pair<double, std::size_t> near{bound(nodes_[number + 1].box), number + 1};
    std::pair<double, std::size_t> far{bound(nodes_[node.right].box), node.right};
    if (far < near) std::swap(near, far);
    pending[size++] = far;
    pending[size++] = near;
  }
}

template <typename Visit>
bool SegmentTree::visit_meeting(const SegmentTree& moved, const Vector& by,
                                const Visit& visit) const {
  if (empty() || moved.empty()) return false;
  const IntervalPoint way = interval(by);
  std::array<std::pair<std::size_t, std::size_t>, 256> pending;  // each halves a box
  std::size_t size = 0;
  pending[size++] = {0, 0};
  while (size > 0) {
    const auto [a, b] = pending[--size];
    const Node& node = nodes_[a];
    const Node& other = moved.nodes_[b];
    if (!meet(node.box, translated(other.box, way))) continue;
    if (node.is_leaf() && other.is_leaf()) {
      for (std::size_t j = other.begin; j < other.end; ++j) {
        const Box box = translated(moved.boxes_[moved.order_[j]], way);
        for (std::size_t i = node.begin; i < node.end; ++i)
          if (meet(boxes_[order_[i]], box) && visit(order_[i], moved.order_[j])) return true;
      }
    } else if (other.is_leaf() ||
               (!node.is_leaf() && node.end - node.begin > other.end - other.begin)) {
      pending[size++] = {a + 1, b};
      pending[size++] = {node.right, b};
    } else {
      pending[size++] = {a, b + 1};
      pending[size++] = {a, other.right};
    }
  }
  return false;
}

}  // namespace oplus
