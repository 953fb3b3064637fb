// SPDX-License-Identifier: MIT
#include "checked/collision/segment_tree.hpp"

#include "reference/chains/near_point.hpp"
#include "reference/definitions/squared_distance.hpp"

namespace oplus {

namespace {

/// Whether all of b is certainly on one side of the line through a.
bool is_beside(const IntervalSegment& a, const IntervalSegment& b) {
  const int of_source = orientation_in_doubles(a.source, a.target, b.source);
  return of_source != 0 && orientation_in_doubles(a.source, a.target, b.target) == of_source;
}

bool is_above(const NearPoint& a, const NearPoint& b) {
  const std::optional<int> known = compare(a.near.y, b.near.y);
  return known ? *known > 0 : a.exact->y > b.exact->y;
}

/// A segment that a ray to the right crosses, from its lower to its upper end.
struct Crossed {
  NearPoint low;
  NearPoint high;
};

/// Of two segments that one ray crosses.
bool is_left_of(const Crossed& a, const Crossed& b) {
  if (is_above(b.low, a.low)) return !is_left_of(b, a);
  // They touch at most, so that one of them is on one side of the other.
  const int side = orientation(b.low, b.high, a.low);
  return (side != 0 ? side : orientation(b.low, b.high, a.high)) > 0;
}

Interval squared_length(const IntervalPoint& v) {
  const Interval length = v.x * v.x + v.y * v.y;
  return {std::max(length.low, 0.0), length.high};
}

}  // namespace

SegmentTree::SegmentTree(std::vector<Segment> segments) : segments_(std::move(segments)) {
  certified_.reserve(segments_.size());
  boxes_.reserve(segments_.size());
  for (const Segment& s : segments_) {
    certified_.push_back(interval(s));
    boxes_.push_back(box_of(certified_.back()));
  }
  order_ = halving_order(boxes_);
  std::vector<Box> in_order;
  in_order.reserve(boxes_.size());
  for (const std::uint32_t i : order_) in_order.push_back(boxes_[i]);
  boxes_ = std::move(in_order);
  tree_ = Tree(boxes_);
}

std::vector<std::size_t> near(const Segment& segment, const SegmentTree& segments) {
  const IntervalSegment s = interval(segment);
  std::vector<std::size_t> result;
  segments.look_at_meeting(box_of(s), [&](std::size_t i) {
    const IntervalSegment& t = segments.certified(i);
    if (!is_beside(s, t) && !is_beside(t, s)) result.push_back(i);
  });
  return result;
}

bool lies_on_one(const Point& p, const SegmentTree& segments) {
  const IntervalPoint place = interval(p);
  bool lies = false;
  segments.look_at_meeting(box_of(place), [&](std::size_t i) {
    const IntervalSegment& s = segments.certified(i);
    lies =
        lies || (orientation_in_doubles(s.source, s.target, place) == 0 && lies_on(p, segments[i]));
  });
  return lies;
}

std::vector<Segment> cut_where_met(const Segment& segment, const SegmentTree& others) {
  std::vector<Point> met;
  for (const std::size_t i : near(segment, others)) {
    const std::vector<Point> common = intersection(segment, others[i]);
    met.insert(met.end(), common.begin(), common.end());
  }
  return cut(segment, std::move(met));
}

std::optional<Crossing> first_to_the_right(const Point& x, const SegmentTree& segments) {
  // The ray is an infinitesimal above x, so that it meets no end.
  const NearPoint from = near_point(x);
  std::optional<Crossed> first;
  std::optional<Crossing> result;
  double limit = std::numeric_limits<double>::max();
  segments.look_for(
      limit,
      [&](const Box& box) {
        const bool may_cross = from.near.x.low <= box.high_x && box.low_y <= from.near.y.high &&
                               from.near.y.low <= box.high_y;
        return may_cross ? box.low_x : SegmentTree::nothing;
      },
      [&](std::size_t i) {
        const NearPoint source{segments.certified(i).source, &segments[i].source};
        const NearPoint target{segments.certified(i).target, &segments[i].target};
        const bool runs_up = is_above(target, from);
        if (is_above(source, from) == runs_up) return limit;
        const Crossed here = runs_up ? Crossed{source, target} : Crossed{target, source};
        if (orientation(here.low, here.high, from) < 0 || (first && !is_left_of(here, *first)))
          return limit;
        first = here;
        result = {i, runs_up};
        return limit = std::max(here.low.near.x.high, here.high.near.x.high);
      });
  return result;
}

Interval squared_distance(const IntervalPoint& x, const IntervalSegment& s) {
  const IntervalPoint along = s.target - s.source;
  const IntervalPoint to = x - s.source;
  const Interval from_source = squared_length(to);
  const Interval at = along.x * to.x + along.y * to.y;
  if (at.high <= 0) return from_source;
  const Interval from_target = squared_length(x - s.target);
  const Interval length = squared_length(along);
  if (at.low >= length.high) return from_target;
  const Interval across = cross(along, to);
  const Interval from_line = across * across / length;
  const bool is_between = at.low >= 0 && at.high <= length.low;
  const double most = std::min(from_source.high, from_target.high);
  return {std::max(from_line.low, 0.0), is_between ? std::min(from_line.high, most) : most};
}

Interval squared_distance(const IntervalSegment& a, const IntervalSegment& b) {
  Interval least{SegmentTree::nothing, SegmentTree::nothing};
  for (const Interval& here : {squared_distance(a.source, b), squared_distance(a.target, b),
                               squared_distance(b.source, a), squared_distance(b.target, a)}) {
    least.low = std::min(least.low, here.low);
    least.high = std::min(least.high, here.high);
  }
  if (!is_beside(a, b) && !is_beside(b, a)) least.low = 0;  // they may cross
  return least;
}

Rational squared_distance(const Point& x, const SegmentTree& segments, const Rational& enough,
                          std::size_t left_out) {
  const IntervalPoint place = interval(x);
  const Box box = box_of(place);
  const double enough_in_doubles = interval(enough).low;
  std::vector<std::pair<double, std::size_t>> candidates;
  double most = SegmentTree::nothing;
  segments.look_for(
      most, [&](const Box& b) { return squared_gap(b, box); },
      [&](std::size_t i) {
        if (i == left_out) return most;
        const Interval here = squared_distance(place, segments.certified(i));
        if (here.low <= most) candidates.emplace_back(here.low, i);
        most = std::min(most, here.high);
        return most <= enough_in_doubles ? -1 : most;
      });
  if (most <= enough_in_doubles) return enough;
  std::optional<Rational> least;
  for (const auto& [low, i] : candidates) {
    if (low > most) continue;
    Rational here = squared_distance(x, segments[i]);
    if (!least || here < *least) least = std::move(here);
    if (*least <= enough) break;
  }
  return *least;
}

}  // namespace oplus
