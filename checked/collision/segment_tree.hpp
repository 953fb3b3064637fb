// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "checked/boxes/box_tree.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

/// Segments, or points, in a tree of boxes: those near a place, or near those of another tree (thesis,
/// Section 5.1.2), are found without a look at all. Built in O(n log n), in halving_order.
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

  /// Calls `look(i, j)` for segment i of this tree and segment j of another wherever the squared distance of
  /// their boxes is at most `limit`, near ones first as far as the trees know. `look` returns the limit from then
  /// on.
  template <typename Look>
  void look_for_near(const SegmentTree& other, double limit, const Look& look) const;

  static constexpr double nothing = std::numeric_limits<double>::infinity();

 private:
  using Tree = BoxTree<4>;

  /// A part of this tree and one of another.
  struct Pair {
    Tree::Range a, b;

    bool are_leaves() const { return a.is_leaf() && b.is_leaf(); }
    /// The larger one is halved. Requires: they are not both leaves.
    std::pair<Pair, Pair> halves() const {
      if (b.is_leaf() || (!a.is_leaf() && a.size() > b.size())) {
        const auto [first, second] = a.halves();
        return {{first, b}, {second, b}};
      }
      const auto [first, second] = b.halves();
      return {{a, first}, {a, second}};
    }
  };

  std::vector<Segment> segments_;
  std::vector<IntervalSegment> certified_;
  std::vector<std::uint32_t> order_;  ///< the segments, in that of the tree,
  std::vector<Box> boxes_;            ///< and their boxes
  Tree tree_;
};

/// Those which may have a point in common with a segment.
std::vector<std::size_t> near(const Segment& segment, const SegmentTree& segments);

/// As the functions of these names for vectors (segment.hpp, cut_at_intersections.hpp,
/// squared_distance.hpp).
bool lies_on_one(const Point& p, const SegmentTree& segments);
std::vector<Segment> cut_where_met(const Segment& segment, const SegmentTree& others);

/// The segment that a ray to the right crosses first, from infinitely little above x: it passes no end.
/// Requires: segments neither cross nor overlap.
struct Crossing {
  std::size_t segment;
  bool runs_up;
};
std::optional<Crossing> first_to_the_right(const Point& x, const SegmentTree& segments);

/// The squared distance from the nearest one, or a number that is not larger than `enough`, where that
/// distance is not. Segment `left_out` does not count. Requires: there is another.
Rational squared_distance(const Point& x, const SegmentTree& segments, const Rational& enough,
                          std::size_t left_out = static_cast<std::size_t>(-1));

/// Bounds of the squared distance of x from a segment.
Interval squared_distance(const IntervalPoint& x, const IntervalSegment& s);

/// Bounds of that of two segments.
Interval squared_distance(const IntervalSegment& a, const IntervalSegment& b);

template <typename Bound, typename Look>
void SegmentTree::look_for(double limit, const Bound& bound, const Look& look) const {
  if (empty()) return;
  std::array<std::pair<double, Tree::Range>, 64> pending;  // halving makes no tree as deep
  std::size_t size = 0;
  const auto add = [&](const Tree::Range& range) {
    pending[size++] = {bound(tree_[range]), range};
  };
  add(tree_.all());
  while (size > 0) {
    const auto [least, range] = pending[--size];
    if (least > limit) continue;
    if (range.is_leaf()) {
      for (std::size_t i = range.begin; i < range.end; ++i)
        if (bound(boxes_[i]) <= limit) limit = look(order_[i]);
      continue;
    }
    const auto [first, second] = range.halves();
    add(second);
    add(first);
    if (pending[size - 2].first < pending[size - 1].first)
      std::swap(pending[size - 2], pending[size - 1]);
  }
}

template <typename Visit>
bool SegmentTree::visit_meeting(const SegmentTree& moved, const Vector& by,
                                const Visit& visit) const {
  if (empty() || moved.empty()) return false;
  const IntervalPoint way = interval(by);
  std::array<Pair, 128> pending;  // each halves a box
  std::size_t size = 0;
  pending[size++] = {tree_.all(), moved.tree_.all()};
  while (size > 0) {
    const Pair pair = pending[--size];
    const auto& [a, b] = pair;
    if (!meet(tree_[a], translated(moved.tree_[b], way))) continue;
    if (!pair.are_leaves()) {
      const auto [first, second] = pair.halves();
      pending[size++] = first;
      pending[size++] = second;
      continue;
    }
    for (std::size_t j = b.begin; j < b.end; ++j) {
      const Box box = translated(moved.boxes_[j], way);
      for (std::size_t i = a.begin; i < a.end; ++i)
        if (meet(boxes_[i], box) && visit(order_[i], moved.order_[j])) return true;
    }
  }
  return false;
}

template <typename Look>
void SegmentTree::look_for_near(const SegmentTree& other, double limit, const Look& look) const {
  if (empty() || other.empty()) return;
  std::array<std::pair<double, Pair>, 128> pending;  // as above
  std::size_t size = 0;
  const auto add = [&](const Pair& pair) {
    pending[size++] = {squared_gap(tree_[pair.a], other.tree_[pair.b]), pair};
  };
  add({tree_.all(), other.tree_.all()});
  while (size > 0) {
    const auto [least, pair] = pending[--size];
    if (least > limit) continue;
    if (!pair.are_leaves()) {
      const auto [first, second] = pair.halves();
      add(second);
      add(first);
      if (pending[size - 2].first < pending[size - 1].first)
        std::swap(pending[size - 2], pending[size - 1]);
      continue;
    }
    for (std::size_t i = pair.a.begin; i < pair.a.end; ++i)
      for (std::size_t j = pair.b.begin; j < pair.b.end; ++j)
        if (squared_gap(boxes_[i], other.boxes_[j]) <= limit)
          limit = look(order_[i], other.order_[j]);
  }
}

}  // namespace oplus
