// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "checked/verify/closeness.hpp"
#include "checked/verify/root_number.hpp"
#include "reference/definitions/squared_distance.hpp"

namespace oplus {

namespace {

/// A part of an edge, and how far from the other set it is at most: the distance from one segment is
/// convex, so it is largest at an end.
struct Part {
  Segment segment;
  Rational most;

  friend bool operator<(const Part& a, const Part& b) { return a.most < b.most; }
};

/// `enough`: more than that need not be known.
Part part_of(const Segment& s, const SegmentTree& to, const Rational& enough) {
  const IntervalSegment near_s = interval(s);
  const Box source = box_of(near_s.source);
  const Box target = box_of(near_s.target);
  const double enough_in_doubles = interval(enough).low;
  double most_in_doubles = SegmentTree::nothing;
  std::vector<std::pair<double, std::size_t>> candidates;
  to.look_for(
      most_in_doubles,
      [&](const Box& box) { return std::max(squared_gap(source, box), squared_gap(target, box)); },
      [&](std::size_t i) {
        const Interval first = squared_distance(near_s.source, to.certified(i));
        const Interval last = squared_distance(near_s.target, to.certified(i));
        candidates.emplace_back(std::max(first.low, last.low), i);
        most_in_doubles = std::min(most_in_doubles, std::max(first.high, last.high));
        return most_in_doubles <= enough_in_doubles ? -1 : most_in_doubles;
      });
  if (most_in_doubles <= enough_in_doubles) return {s, enough};
  std::optional<Rational> most;
  for (const auto& [low, i] : candidates) {
    if (low > most_in_doubles) continue;
    Rational here = squared_distance(s.source, to[i]);
    if (most && here >= *most) continue;
    here = std::max(here, squared_distance(s.target, to[i]));
    if (!most || here < *most) most = std::move(here);
    if (*most <= enough) break;
  }
  return {s, *most};
}

struct Farthest {
  Rational least = -1;  ///< the squared distance there
  Point point;
  Rational most = 0;
};

/// The directed distance, by branch and bound: parts are halved until no part can be much farther
/// away than a point that was seen.
void look_for_farther(const std::vector<Segment>& from, const SegmentTree& to, Farthest& farthest) {
  const auto see = [&](const Point& x) {
    Rational here = squared_distance(x, to, farthest.least);
    if (here <= farthest.least) return;
    farthest.least = std::move(here);
    farthest.point = x;
  };
  for (const Segment& s : from) {
    see(s.source);
    see(s.target);
  }
  std::priority_queue<Part> parts;
  for (const Segment& s : from) {
    // Cut where the other set meets it, so that what runs along it is no distance from the pieces.
    if (s.source != s.target) {
      if (part_of(s, to, farthest.least).most <= farthest.least) continue;
      for (const Segment& piece : cut_where_met(s, to))
        parts.push(part_of(piece, to, farthest.least));
    }
  }
  const Rational accuracy(1, 1 << 20);
  while (!parts.empty() && parts.top().most > farthest.least * (1 + accuracy)) {
    const Segment s = parts.top().segment;
    parts.pop();
    const Point middle = midpoint(s.source, s.target);
    see(middle);
    for (const Segment& half : {Segment{s.source, middle}, {middle, s.target}})
      parts.push(part_of(half, to, farthest.least));
  }
  farthest.most = std::max(farthest.most, farthest.least);
  if (!parts.empty()) farthest.most = std::max(farthest.most, parts.top().most);
}

/// Of a segment: places along it, ends included.
struct Stretch {
  RootNumber low;
  RootNumber high;
};

void extend(std::optional<Stretch>& stretch, const RootNumber& low, const RootNumber& high) {
  if (!stretch) {
    stretch = Stretch{low, high};
    return;
  }
  if (low < stretch->low) stretch->low = low;
  if (stretch->high < high) stretch->high = high;
}

/// The t for which s.source + t direction_of(s) is near enough to `to`. A convex set: that of the
/// disks around both ends and of the rectangle between them.
std::optional<Stretch> near_part(const Segment& s, const Segment& to, const Rational& squared) {
  const Vector along = direction_of(s);
  const Rational length = squared_length(along);
  std::optional<Stretch> result;
  for (const Point& centre : {to.source, to.target}) {
    const Vector from = s.source - centre;
    const Rational half = dot(along, from);
    const Rational discriminant = half * half - length * (squared_length(from) - squared);
    if (discriminant < 0) continue;
    const Rational middle = -half / length;
    const Rational step = 1 / length;
    extend(result, {middle, -step, discriminant}, {middle, step, discriminant});
  }
  const Vector other = direction_of(to);
  const Rational other_length = squared_length(other);
  if (other_length == 0) return result;
  const Vector from = s.source - to.source;

  // Beside the other segment, from one of its ends to the other...
  std::optional<Stretch> beside;
  const Rational start = dot(other, from);
  const Rational slope = dot(other, along);
  if (slope != 0) {
    Rational first = -start / slope;
    Rational last = (other_length - start) / slope;
    if (last < first) std::swap(first, last);
    beside = Stretch{{first}, {last}};
  } else if (start < 0 || start > other_length) {
    return result;
  }
  // ... and not too far from its line.
  const Rational across = cross(other, from);
  const Rational turn = cross(other, along);
  if (turn != 0) {
    const Rational middle = -across / turn;
    const Rational step = 1 / abs(turn);
    const RootNumber low{middle, -step, squared * other_length};
    const RootNumber high{middle, step, squared * other_length};
    if (!beside) {
      beside = Stretch{low, high};
    } else {
      if (beside->low < low) beside->low = low;
      if (high < beside->high) beside->high = high;
    }
  } else if (across * across > squared * other_length) {
    return result;
  }
  if (beside->low <= beside->high) extend(result, beside->low, beside->high);
  return result;
}

bool is_covered(const Segment& s, const SegmentTree& to, const Rational& squared) {
  if (s.source == s.target) return squared_distance(s.source, to, squared) <= squared;
  if (part_of(s, to, squared).most <= squared) return true;
  std::vector<Stretch> near;
  const Box around = box_of(interval(s));
  const double most = interval(squared).high;
  to.look_for(
      most, [&](const Box& box) { return squared_gap(around, box); },
      [&](std::size_t i) {
        if (std::optional<Stretch> part = near_part(s, to[i], squared))
          near.push_back(std::move(*part));
        return most;
      });
  std::sort(near.begin(), near.end(),
            [](const Stretch& a, const Stretch& b) { return a.low < b.low; });
  RootNumber reached{0};
  for (const Stretch& part : near) {
    if (reached < part.low) return false;
    if (reached < part.high) reached = part.high;
    if (!(reached < RootNumber{1})) return true;
  }
  return false;
}

}  // namespace

bool is_within(const std::vector<Segment>& from, const SegmentTree& to, const Rational& squared) {
  return std::all_of(from.begin(), from.end(),
                     [&](const Segment& s) { return !to.empty() && is_covered(s, to, squared); });
}

BoundaryDistance distance(const std::vector<Segment>& right, const std::vector<Segment>& given) {
  Farthest farthest;
  look_for_farther(right, given, farthest);
  const Rational of_right = farthest.least;
  look_for_farther(given, right, farthest);
  return {farthest.least, farthest.most, farthest.point, farthest.least > of_right};
}

BoundaryDistance distance_of_given(const std::vector<Segment>& right,
                                   const std::vector<Segment>& given) {
  Farthest farthest;
  look_for_farther(given, right, farthest);
  return {farthest.least, farthest.most, farthest.point, true};
}

}  // namespace oplus
