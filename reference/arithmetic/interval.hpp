// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "reference/definitions/segment.hpp"

namespace oplus {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "a double is rounded to nearest, once");

/// Two doubles between which a number certainly is. Neither end is NaN; the low one may be -∞, the
/// high one ∞. Arithmetic rounds to nearest and then moves the ends apart.
/// Requires: rounding to nearest, with subnormal numbers, which is how every program starts.
/// The sum of two exact numbers (low == high) is exact where it is a double; their product where they
/// have at most 26 significant bits, as integers below 2^26 have, and it is not extreme.
struct Interval {
  double low = 0;
  double high = 0;
};

inline constexpr Interval any_number{-std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity()};

/// The interval between any two numbers that round to these doubles.
///
/// A number x that rounds to a finite double r is between the neighbours of r, and these are at most
/// u away, where u is the distance between doubles in the binade of r: 2^-52 of a power of two that
/// is not greater than |r|, or the least double. So |r| 2^-52 + least >= u, also when computed, since
/// rounding is monotonic and u is a double. So r - (|r| 2^-52 + least), rounded, is not greater than
/// r - u, rounded, which is a double or -∞ and not greater than the neighbour of r, nor than x. The same
/// holds for the high end. Where r is infinite, an end becomes infinite the right way, or NaN.
inline Interval outward(double low, double high) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  low -= std::abs(low) * 0x1p-52 + least;
  high += std::abs(high) * 0x1p-52 + least;
  return low <= high ? Interval{low, high} : any_number;
}

/// Requires: neither is NaN.
inline bool is_exact(const Interval& a) { return a.low == a.high; }

inline Interval operator+(const Interval& a, const Interval& b) {
  const double low = a.low + b.low;
  if (is_exact(a) && is_exact(b)) {
    // Knuth's TwoSum: what rounding took away, exactly; NaN where the sum overflows.
    const double of_b = low - a.low;
    if ((a.low - (low - of_b)) + (b.low - of_b) == 0) return {low, low};
  }
  return outward(low, a.high + b.high);
}
inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

inline Interval operator*(const Interval& a, const Interval& b) {
  const double product = a.low * b.low;
  if (is_exact(a) && is_exact(b)) {
    // At most 26 significant bits each: the last 27 of the fraction are zero.
    const auto bits = std::bit_cast<std::uint64_t>(a.low) | std::bit_cast<std::uint64_t>(b.low);
    const bool is_small = (bits & ((std::uint64_t{1} << 27) - 1)) == 0;
    const double size = std::abs(product);
    if (product == 0 ? a.low == 0 || b.low == 0 : is_small && size > 0x1p-960 && size <= DBL_MAX)
      return {product, product};
    return outward(product, product);
  }
  // 0 * ∞ is NaN, which std::min and std::max pass on or leave out; where they leave it out, another
  // product is zero, or two are -∞ and ∞.
  double low = product, high = product;
  for (const double other : {a.low * b.high, a.high * b.low, a.high * b.high}) {
    low = std::min(low, other);
    high = std::max(high, other);
  }
  return outward(low, high);
}

inline Interval operator/(const Interval& a, const Interval& b) {
  if ((b.low <= 0 && b.high >= 0) || std::isinf(b.low) || std::isinf(b.high)) return any_number;
  const double quotients[] = {a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high};
  return outward(*std::min_element(quotients, quotients + 4),
                 *std::max_element(quotients, quotients + 4));
}

/// Negative, zero or positive; empty where the intervals do not tell.
inline std::optional<int> compare(const Interval& a, const Interval& b) {
  if (a.high < b.low) return -1;
  if (a.low > b.high) return 1;
  if (is_exact(a) && is_exact(b)) return 0;
  return std::nullopt;
}

inline std::optional<int> sign(const Interval& a) { return compare(a, Interval{}); }

/// The sign of x - y, of two products of exact numbers, or of sums of two such, that were rounded to
/// these doubles; empty where they are too close.
///
/// With ε = 2^-53, each factor has a relative error of ε at most and a product another ε, or 2^-1074 where
/// it underflows, so that x is within 4ε |left| + 2^-1073 of `left`, and the same for y; the difference has
/// another ε. The bound has 8ε, which leaves room for its own rounding. It is infinite, or NaN, where
/// anything overflows.
inline std::optional<int> sign_of_difference(double left, double right) {
  const double difference = left - right;
  if (std::abs(difference) > (std::abs(left) + std::abs(right)) * 0x1p-50 + 0x1p-1000)
    return difference > 0 ? 1 : -1;
  return std::nullopt;
}

/// Exact where the number is a double.
Interval interval(const Rational& value);

struct IntervalPoint {
  Interval x;
  Interval y;
};

inline IntervalPoint interval(const Point& p) { return {interval(p.x), interval(p.y)}; }

inline IntervalPoint operator+(const IntervalPoint& a, const IntervalPoint& b) {
  return {a.x + b.x, a.y + b.y};
}
inline IntervalPoint operator-(const IntervalPoint& a, const IntervalPoint& b) {
  return {a.x - b.x, a.y - b.y};
}

inline Interval cross(const IntervalPoint& u, const IntervalPoint& v) {
  return u.x * v.y - u.y * v.x;
}

/// The orientation of three points if doubles show it, otherwise 0. An int, since std::optional made
/// a loop over millions of points a third slower.
///
/// Computed with the low ends, as in sign_of_difference. The high ends are at most x and y away, which
/// changes the cross product by at most (|ux| + |vx|) y + (|uy| + |vy|) x + 2 x y. The bound is larger than
/// the sum of these by more than its own rounding errors. Infinities and NaN give 0.
inline int orientation_in_doubles(const IntervalPoint& a, const IntervalPoint& b,
                                  const IntervalPoint& c) {
  const double ux = b.x.low - a.x.low, uy = b.y.low - a.y.low;
  const double vx = c.x.low - a.x.low, vy = c.y.low - a.y.low;
  const double x = (a.x.high - a.x.low) + (b.x.high - b.x.low) + (c.x.high - c.x.low);
  const double y = (a.y.high - a.y.low) + (b.y.high - b.y.low) + (c.y.high - c.y.low);
  const double left = ux * vy, right = uy * vx;
  const double bound =
      0x1p-50 * (std::abs(left) + std::abs(right)) + DBL_MIN +
      1.01 * ((std::abs(ux) + std::abs(vx)) * y + (std::abs(uy) + std::abs(vy)) * x + 2 * x * y);
  return (left - right > bound) - (left - right < -bound);
}

/// The sign of the cross product; empty where the intervals do not tell. Of exact numbers they always tell, but
/// where a product overflows or is extremely small.
std::optional<int> sign_of_cross(const IntervalPoint& u, const IntervalPoint& v);

/// orientation, where doubles do not show it.
std::optional<int> orientation_of_intervals(const IntervalPoint& a, const IntervalPoint& b,
                                            const IntervalPoint& c);

/// The orientation of three points; empty where the intervals do not tell.
inline std::optional<int> orientation(const IntervalPoint& a, const IntervalPoint& b,
                                      const IntervalPoint& c) {
  if (const int known = orientation_in_doubles(a, b, c)) return known;
  return orientation_of_intervals(a, b, c);
}

struct IntervalSegment {
  IntervalPoint source;
  IntervalPoint target;
};

inline IntervalSegment interval(const Segment& s) {
  return {interval(s.source), interval(s.target)};
}

inline IntervalSegment translated(const IntervalSegment& s, const IntervalPoint& by) {
  return {s.source + by, s.target + by};
}

}  // namespace oplus
