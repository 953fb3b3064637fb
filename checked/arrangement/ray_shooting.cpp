// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/ray_shooting.hpp"

#include <CGAL/Interval_skip_list.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// The slabs between neighbouring heights of the segments' ends that a segment passes through:
/// `from` to `to`, both included. Horizontal segments pass through none.
class Slabs {
 public:
  using Value = std::int64_t;

  Slabs() = default;
  Slabs(Value from, Value to, std::size_t segment) : from_(from), to_(to), segment_(segment) {}

  std::size_t segment() const { return segment_; }

  // What CGAL's interval skip list asks of an interval.
  Value inf() const { return from_; }
  Value sup() const { return to_; }
  bool inf_closed() const { return true; }
  bool sup_closed() const { return true; }
  bool contains(Value slab) const { return from_ <= slab && slab <= to_; }
  bool contains_interval(Value from, Value to) const { return from_ <= from && to <= to_; }
  friend bool operator==(const Slabs& a, const Slabs& b) { return a.segment_ == b.segment_; }
  friend bool operator!=(const Slabs& a, const Slabs& b) { return !(a == b); }

 private:
  Value from_ = 0;
  Value to_ = 0;
  std::size_t segment_ = 0;
};

/// A point moved infinitesimally: by ε·first + ε²·second.
struct ShiftedPoint {
  Point at;
  Vector first;
  Vector second;
};

/// The middle of an edge, moved along the edge, upwards, and then to its right. On a horizontal
/// edge the second step alone decides the height. So no segment's end is at the height of the
/// shifted point, and it is on no segment (Section 5.2.2).
ShiftedPoint right_of_middle(const Segment& edge) {
  const Vector d = direction_of(edge);
  return {midpoint(edge.source, edge.target), sign(d.y) < 0 ? -d : d, {d.y, -d.x}};
}

bool is_above(const ShiftedPoint& p) { return sign(p.first.y) > 0 || sign(p.second.y) > 0; }

}  // namespace

struct RayShooting::Tree {
  explicit Tree(std::vector<Segment> convolution) : segments(std::move(convolution)) {
    for (const Segment& s : segments) {
      heights.push_back(s.source.y);
      heights.push_back(s.target.y);
    }
    heights = sorted_without_copies(std::move(heights));
    std::vector<Slabs> intervals;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const auto [low, high] =
          std::minmax({number_below(segments[i].source.y), number_below(segments[i].target.y)});
      if (low < high) intervals.emplace_back(low, high - 1, i);
      ends.push_back(interval(segments[i]));
    }
    slabs.insert(intervals.begin(), intervals.end());
  }

  /// How many heights are below y: the slab that ends at y or contains it has that number less one.
  std::int64_t number_below(const Rational& y) const {
    return std::lower_bound(heights.begin(), heights.end(), y) - heights.begin();
  }

  std::int64_t slab_of(const ShiftedPoint& p) const {
    const std::int64_t below = number_below(p.at.y);
    const bool at_a_height =
        below < std::ssize(heights) && heights[static_cast<std::size_t>(below)] == p.at.y;
    return at_a_height && is_above(p) &&
                   !OPLUS_MUTANT(
                       "rays-shift-down",
                       "a ray at the height of a vertex passes below it, though it starts above")
               ? below
               : below - 1;
  }

  /// Positive if the point is to the left of a segment's line, negative if to the right.
  int side(const ShiftedPoint& p, const IntervalPoint& at, std::size_t i) const {
    const std::optional<int> filtered = orientation(ends[i].source, ends[i].target, at);
    if (filtered && *filtered != 0) return *filtered;
    const Segment& s = segments[i];
    const int exact = orientation(s.source, s.target, p.at);
    if (exact != 0) return exact;
    const Vector d = direction_of(s);
    const int by_first = sign(cross(d, p.first));
    if (by_first != 0) return by_first;
    const int by_second = sign(cross(d, p.second));
    return OPLUS_MUTANT("rays-start-left-of-their-edge",
                        "a ray from an edge starts in the face to its left")
               ? -by_second
               : by_second;
  }

  std::vector<Segment> segments;
  std::vector<IntervalSegment> ends;
  std::vector<Rational> heights;
  CGAL::Interval_skip_list<Slabs> slabs;
};

RayShooting::RayShooting(std::vector<Segment> convolution)
    : tree_(std::make_unique<Tree>(std::move(convolution))) {}

RayShooting::~RayShooting() = default;

int RayShooting::winding_number_right_of(const Segment& edge) const {
  const ShiftedPoint p = right_of_middle(edge);
  const IntervalPoint at = interval(p.at);
  std::vector<Slabs> met;
  tree_->slabs.find_intervals(tree_->slab_of(p), std::back_inserter(met));
  int crossings = 0;
  for (const Slabs& candidate : met) {
    const Segment& s = tree_->segments[candidate.segment()];
    const int side = tree_->side(p, at, candidate.segment());
    OPLUS_ENSURES(side != 0, "Section 5.2.2");
    const bool upwards = s.source.y < s.target.y;
    if (upwards && side > 0) ++crossings;
    if (!upwards && side < 0) --crossings;
  }
  return crossings;
}

}  // namespace oplus
