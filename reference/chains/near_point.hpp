// SPDX-License-Identifier: MIT
#pragma once

#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// A point, which must stay where it is, with intervals around its coordinates, which decide most
/// questions.
struct NearPoint {
  IntervalPoint near;
  const Point* exact;
};

inline NearPoint near_point(const Point& p) { return {interval(p), &p}; }

/// Lexicographic: negative, zero or positive.
inline int compare(const NearPoint& a, const NearPoint& b) {
  if (a.exact == b.exact) return 0;
  const auto of = [](const Interval& near_a, const Interval& near_b, const Rational& x,
                     const Rational& y) {
    const std::optional<int> known = compare(near_a, near_b);
    return known ? *known : cmp(x, y);
  };
  const int by_x = of(a.near.x, b.near.x, a.exact->x, b.exact->x);
  return by_x != 0 ? by_x : of(a.near.y, b.near.y, a.exact->y, b.exact->y);
}

inline int orientation(const NearPoint& a, const NearPoint& b, const NearPoint& c) {
  const std::optional<int> known = orientation(a.near, b.near, c.near);
  return known ? *known : orientation(*a.exact, *b.exact, *c.exact);
}

/// The sign of twice_area(chain), whose own denominator grows with the chain.
inline int sign_of_area(const Chain& chain) {
  if (chain.empty()) return 0;
  Interval twice;
  const IntervalPoint first = interval(chain[0]);
  IntervalPoint last;
  for (const Point& p : chain) {
    const IntervalPoint here = interval(p) - first;
    twice = twice + cross(last, here);
    last = here;
  }
  const std::optional<int> known = sign(twice);
  return known ? *known : sgn(twice_area(chain));
}

}  // namespace oplus
