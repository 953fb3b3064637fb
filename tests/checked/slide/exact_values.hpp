// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "checked/operations/image.hpp"
#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_summands.hpp"
#include "checked/slide/integer_vector.hpp"
#include "reference/definitions/segment.hpp"
#include "reference/families/random.hpp"

namespace oplus::slide {

// What the stages of arithmetic compute, as rationals that know nothing of stages.

using AllNumbers = testing::Types<SmallNumbers, WideNumbers, AnyNumbers, RationalNumbers>;
using LimitedNumbers = testing::Types<SmallNumbers, WideNumbers>;

template <typename Value>
mpz_class integer(const Value& value) {
  if constexpr (std::is_same_v<Value, std::int64_t>)
    return {static_cast<long>(value)};
  else
    return mpz_class(value.str());
}

/// The other way round. Requires: it fits.
template <typename Numbers>
typename Numbers::Value value(const mpz_class& integer) {
  if constexpr (is_small<Numbers>)
    return integer.get_si();
  else
    return typename Numbers::Value(integer.get_str());
}

template <typename Numbers>
Fraction<Numbers> fraction(const mpz_class& n, const mpz_class& d) {
  return {value<Numbers>(n), value<Numbers>(d)};
}

template <typename Numbers>
Rational place_of(const Fraction<Numbers>& fraction) {
  return Rational(integer(fraction.numerator())) / integer(fraction.denominator());
}

/// A segment that need not be of the convolution.
template <typename Numbers>
Track<Numbers> track_on(const IntegerSegment<Numbers>& segment, const Scaling& scaling) {
  const NearSegment near = slide::near(segment, scaling);
  return {segment, near, error_of_places(near, near)};
}

/// Of a segment's line, open or closed.
struct Places {
  Rational from, to;

  friend bool operator==(const Places&, const Places&) = default;
  friend void PrintTo(const Places& p, std::ostream* out) { *out << p.from << " to " << p.to; }
};

template <typename Found>
std::optional<Places> places(const std::optional<Found>& found) {
  if (!found) return std::nullopt;
  return Places{place_of(found->from), place_of(found->to)};
}

/// Of the same segment the other way round.
inline std::optional<Places> from_the_end(const std::optional<Places>& places) {
  if (!places) return std::nullopt;
  return Places{1 - places->to, 1 - places->from};
}

/// From one point to another. Requires: integer coordinates.
template <typename Numbers>
IntegerSegment<Numbers> integer_segment(const Segment& s) {
  const Vector d = direction_of(s);
  return {{value<Numbers>(s.source.x.get_num()), value<Numbers>(s.source.y.get_num())},
          {value<Numbers>(d.x.get_num()), value<Numbers>(d.y.get_num())}};
}

/// 2 to a power, which may be negative.
inline Rational power_of_two(int exponent) {
  const mpz_class power = mpz_class(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

inline Segment image(const AffineMap& map, const Segment& s) {
  return {map(s.source), map(s.target)};
}

inline AffineMap quarter_turns(int times) {
  constexpr int cosine[] = {1, 0, -1, 0};
  const int sine = cosine[(times + 3) % 4];
  return {cosine[times % 4], -sine, sine, cosine[times % 4]};
}

/// With integer coordinates from -most to most.
inline Point random_point(Random& random, int most) {
  const int x = uniform(random, -most, most);
  const int y = uniform(random, -most, most);
  return {x, y};
}

inline Segment random_segment(Random& random, int most) {
  while (true) {
    const Point a = random_point(random, most), b = random_point(random, most);
    if (a != b) return {a, b};
  }
}

/// Every combination of the largest and the smallest coordinates of a stage: an edge of each summand,
/// and what is slid along one of them, or along another edge, at a vertex.
template <typename Numbers, typename Visit>
void for_each_slid_edge_at_the_limit(Visit visit) {
  const Rational m = power_of_two(Numbers::bits) - 1;
  const std::vector<Point> corners{{-m, -m}, {m, -m}, {m, m}, {-m, m}};
  for (int k = 0; k < 1 << 10; ++k) {
    const auto corner = [&](int which) {
      return corners[static_cast<std::size_t>(k >> which) % 4];
    };
    const Segment of_p{corner(0), corner(2)}, of_q{corner(4), corner(6)};
    if (of_p.source == of_p.target || of_q.source == of_q.target) continue;
    for (const Segment& edge :
         {of_p, of_q, Segment{corners[0], corners[2]}, Segment{corners[3], corners[1]}})
      visit(Segment{edge.source + corner(8), edge.target + corner(8)}, of_p, of_q);
  }
}

}  // namespace oplus::slide
