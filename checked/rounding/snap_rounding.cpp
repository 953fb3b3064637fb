// SPDX-License-Identifier: MIT
#include "checked/rounding/snap_rounding.hpp"

#include <algorithm>
#include <utility>

#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

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

/// Whether a point is certainly inside a pixel.
bool is_inside(const IntervalPoint& p, const IntervalPoint& centre, double half) {
  const IntervalPoint from = p - centre;
  return -half < from.x.low && from.x.high < half && -half < from.y.low && from.y.high < half;
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
  // The floor of value / step + 1 / 2.
  const mpz_class by = value.get_den() * step.get_num();
  mpz_class multiple = 2 * value.get_num() * step.get_den() + by;
  mpz_fdiv_q(multiple.get_mpz_t(), multiple.get_mpz_t(), mpz_class(2 * by).get_mpz_t());
  return multiple * step;
}

Point nearest_grid_point(const Point& p, const Rational& step) {
  return {nearest_multiple(p.x, step), nearest_multiple(p.y, step)};
}

bool is_on_grid(const Point& p, const Rational& step) {
  const auto is_multiple = [&](const Rational& value) {
    return mpz_divisible_p(mpz_class(value.get_num() * step.get_den()).get_mpz_t(),
                           mpz_class(value.get_den() * step.get_num()).get_mpz_t()) != 0;
  };
  return is_multiple(p.x) && is_multiple(p.y);
}

HotPixels::HotPixels(std::vector<Point> points, const Rational& step)
    : half_(step / 2), half_in_doubles_(interval(half_)) {
  for (Point& p : points) {
    const Point centre = nearest_grid_point(p, step);
    p = centre;  // a copy has no more memory than it needs
  }
  centres_ = sorted_without_copies(std::move(points));
  std::vector<Box> boxes;
  boxes.reserve(centres_.size());
  for (const Point& centre : centres_) boxes.push_back(box_of(interval(centre)));
  order_ = halving_order(boxes);
  std::vector<Box> in_order;
  in_order.reserve(boxes.size());
  for (const std::uint32_t i : order_) in_order.push_back(boxes[i]);
  tree_ = Tree(in_order);
}

std::vector<std::uint32_t> HotPixels::numbers_passed(const Point& source,
                                                     const Point& target) const {
  std::vector<std::uint32_t> result;
  if (tree_.empty()) return result;
  const IntervalSegment s{interval(source), interval(target)};
  const Box around = box_of(s);
  const auto look = [&](std::uint32_t i) {
    const IntervalPoint centre = interval(centres_[i]);
    if (!may_meet(box_of(centre), half_in_doubles_.high, s, around)) return;
    if (is_inside(s.source, centre, half_in_doubles_.low) ||
        is_inside(s.target, centre, half_in_doubles_.low) ||
        passes({source, target}, centres_[i], half_))
      result.push_back(i);
  };
  std::vector<Tree::Range> pending = {tree_.all()};
  while (!pending.empty()) {
    const Tree::Range range = pending.back();
    pending.pop_back();
    if (!may_meet(tree_[range], half_in_doubles_.high, s, around)) continue;
    if (range.is_leaf()) {
      for (std::size_t i = range.begin; i < range.end; ++i) look(order_[i]);
      continue;
    }
    const auto [first, second] = range.halves();
    pending.push_back(first);
    pending.push_back(second);
  }
  // Along the segment, columns and rows of pixels follow each other.
  const bool leftwards = target.x < source.x;
  const bool downwards = target.y < source.y;
  std::ranges::sort(result, [&](std::uint32_t i, std::uint32_t j) {
    const Point &a = centres_[i], &b = centres_[j];
    if (const int x = cmp(a.x, b.x); x != 0) return leftwards ? x > 0 : x < 0;
    const int y = cmp(a.y, b.y);
    return downwards ? y > 0 : y < 0;
  });
  return result;
}

std::vector<Point> HotPixels::passed(const Segment& s) const {
  std::vector<Point> result;
  for (const std::uint32_t i : numbers_passed(s.source, s.target)) result.push_back(centres_[i]);
  return result;
}

}  // namespace oplus
