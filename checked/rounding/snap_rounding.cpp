// SPDX-License-Identifier: MIT
#include "checked/rounding/snap_rounding.hpp"

#include <algorithm>
#include <utility>

#include "reference/arithmetic/floor_of.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

std::vector<Segment> centres_of(const std::vector<Point>& points, const Rational& step) {
  std::vector<Point> centres;
  centres.reserve(points.size());
  for (const Point& p : points) centres.push_back(nearest_grid_point(p, step));
  std::vector<Segment> result;
  for (const Point& p : sorted_without_copies(std::move(centres))) result.push_back({p, p});
  return result;
}

/// The part of a segment in which some conditions hold: from `low` to `high`, where 0 is its source and 1 its target.
struct Part {
  Rational low = 0;
  Rational high = 1;
  bool without_low = false;
  bool without_high = false;

  bool is_empty() const { return low > high || (low == high && (without_low || without_high)); }

  void raise(const Rational& to, bool without) {
    if (to < low) return;
    without_low = without || (to == low && without_low);
    low = to;
  }

  void lower(const Rational& to, bool without) {
    if (to > high) return;
    without_high = without || (to == high && without_high);
    high = to;
  }

  /// Leaves that in which start + t * along is at least `least` and less than `beyond`.
  void clip(const Rational& start, const Rational& along, const Rational& least,
            const Rational& beyond) {
    const bool open =
        OPLUS_MUTANT("pixels-have-no-sides",
                     "an edge is not routed through a pixel of which it touches a side only");
    if (sgn(along) == 0) {
      if (start < least || start >= beyond || (open && start == least)) high = -1;
      return;
    }
    const Rational at_least = (least - start) / along;
    const Rational at_beyond = (beyond - start) / along;
    if (sgn(along) > 0) {
      raise(at_least, open);
      lower(at_beyond, true);
    } else {
      raise(at_beyond, true);
      lower(at_least, open);
    }
  }
};

bool passes(const Segment& s, const Point& centre, const Rational& half) {
  const Vector along = direction_of(s);
  Part part;
  part.clip(s.source.x, along.x, centre.x - half, centre.x + half);
  if (part.is_empty()) return false;
  part.clip(s.source.y, along.y, centre.y - half, centre.y + half);
  return !part.is_empty();
}

/// Whether a box, with that margin around it, may meet a segment.
bool may_meet(const Box& box, double margin, const IntervalSegment& s, const Box& around) {
  const Box larger = enlarged(box, margin);
  if (!meet(larger, around)) return false;
  int sides = 0;
  for (const double at_x : {larger.low_x, larger.high_x})
    for (const double at_y : {larger.low_y, larger.high_y})
      sides += orientation_in_doubles(s.source, s.target, {{at_x, at_x}, {at_y, at_y}});
  return sides != 4 && sides != -4;
}

}  // namespace

Rational nearest_multiple(const Rational& value, const Rational& step) {
  return floor_of(Rational(value / step + Rational(1, 2))) * step;
}

Point nearest_grid_point(const Point& p, const Rational& step) {
  return {nearest_multiple(p.x, step), nearest_multiple(p.y, step)};
}

bool is_on_grid(const Point& p, const Rational& step) {
  return Rational(p.x / step).get_den() == 1 && Rational(p.y / step).get_den() == 1;
}

HotPixels::HotPixels(const std::vector<Point>& points, const Rational& step)
    : half_(step / 2),
      step_(step),
      half_in_doubles_(interval(half_).high),
      centres_(centres_of(points, step)) {}

std::vector<Point> HotPixels::passed(const Segment& s) const {
  const IntervalSegment certified = interval(s);
  const Box around = box_of(certified);
  const Point first = nearest_grid_point(s.source, step_);
  const Point last = nearest_grid_point(s.target, step_);
  std::vector<Point> result;
  centres_.look_for(
      0,
      [&](const Box& box) {
        return may_meet(box, half_in_doubles_, certified, around) ? 0 : SegmentTree::nothing;
      },
      [&](std::size_t i) {
        const Point& centre = centres_[i].source;
        if (centre == first || centre == last || passes(s, centre, half_)) result.push_back(centre);
        return 0;
      });
  // Along the segment, columns and rows of pixels follow each other.
  const bool leftwards = s.target.x < s.source.x;
  const bool downwards = s.target.y < s.source.y;
  std::sort(result.begin(), result.end(), [&](const Point& a, const Point& b) {
    if (const int x = cmp(a.x, b.x); x != 0) return leftwards ? x > 0 : x < 0;
    const int y = cmp(a.y, b.y);
    return downwards ? y > 0 : y < 0;
  });
  return result;
}

}  // namespace oplus
