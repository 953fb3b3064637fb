// SPDX-License-Identifier: MIT
#include "checked/collision/segment_tree.hpp"

#include <cfloat>
#include <cmath>
#include <numeric>
#include <optional>

#include "reference/definitions/squared_distance.hpp"

namespace oplus {

namespace {

constexpr std::size_t leaf_size = 4;

Box around(const Box& a, const Box& b) {
  return {std::min(a.low_x, b.low_x), std::min(a.low_y, b.low_y), std::max(a.high_x, b.high_x),
          std::max(a.high_y, b.high_y)};
}

/// Where an interval goes in an order; only the shape of the tree depends on it.
double middle(double low, double high) {
  return std::max(low, -DBL_MAX) / 2 + std::min(high, DBL_MAX) / 2;
}

/// Whether all of b is certainly on one side of the line through a.
bool is_beside(const IntervalSegment& a, const IntervalSegment& b) {
  const int of_source = orientation_in_doubles(a.source, a.target, b.source);
  return of_source != 0 && orientation_in_doubles(a.source, a.target, b.target) == of_source;
}

Interval squared_length(const IntervalPoint& v) {
  const Interval length = v.x * v.x + v.y * v.y;
  return {std::max(length.low, 0.0), length.high};
}

}  // namespace

Box box_of(const IntervalPoint& p) { return {p.x.low, p.y.low, p.x.high, p.y.high}; }

Box box_of(const IntervalSegment& s) { return around(box_of(s.source), box_of(s.target)); }

/// Each of the five operations is wrong by a 2^53rd at most, or by the least double.
double squared_gap(const Box& a, const Box& b) {
  const double x = std::max({0.0, a.low_x - b.high_x, b.low_x - a.high_x});
  const double y = std::max({0.0, a.low_y - b.high_y, b.low_y - a.high_y});
  const double squared = x * x + y * y;
  return squared < DBL_MIN ? 0 : squared * (1 - 0x1p-48);
}

SegmentTree::SegmentTree(std::vector<Segment> segments)
    : segments_(std::move(segments)), order_(segments_.size()) {
  certified_.reserve(segments_.size());
  boxes_.reserve(segments_.size());
  for (const Segment& s : segments_) {
    certified_.push_back(interval(s));
    boxes_.push_back(box_of(certified_.back()));
  }
  std::iota(order_.begin(), order_.end(), 0);
  if (!segments_.empty()) build(0, segments_.size());
}

void SegmentTree::build(std::size_t begin, std::size_t end) {
  Box box = boxes_[order_[begin]];
  for (std::size_t i = begin + 1; i < end; ++i) box = around(box, boxes_[order_[i]]);
  const std::size_t self = nodes_.size();
  nodes_.push_back({box, begin, end});
  if (end - begin <= leaf_size) return;
  // Where the middles are further apart: long boxes are told apart by their short sides.
  const auto middle_of = [&](std::size_t i) -> std::pair<double, double> {
    const Box& b = boxes_[order_[i]];
    return {middle(b.low_x, b.high_x), middle(b.low_y, b.high_y)};
  };
  const auto [first_x, first_y] = middle_of(begin);
  Box middles{first_x, first_y, first_x, first_y};
  for (std::size_t i = begin + 1; i < end; ++i) {
    const auto [x, y] = middle_of(i);
    middles = around(middles, {x, y, x, y});
  }
  const bool wide = middles.high_x - middles.low_x > middles.high_y - middles.low_y;
  const auto key = [&](std::size_t i) {
    const Box& b = boxes_[i];
    return wide ? middle(b.low_x, b.high_x) : middle(b.low_y, b.high_y);
  };
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(half), at(end),
                   [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  build(begin, half);
  nodes_[self].right = nodes_.size();
  build(half, end);
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
  for (const std::size_t i : near({p, p}, segments))
    if (lies_on(p, segments[i])) return true;
  return false;
}

std::vector<Segment> cut_where_met(const Segment& segment, const SegmentTree& others) {
  std::vector<Point> met;
  for (const std::size_t i : near(segment, others)) {
    const std::vector<Point> common = intersection(segment, others[i]);
    met.insert(met.end(), common.begin(), common.end());
  }
  return cut(segment, std::move(met));
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
