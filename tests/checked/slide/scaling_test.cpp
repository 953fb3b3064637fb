// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/scaling.hpp"

#include <gtest/gtest.h>

#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::slide {
namespace {

const Region unit_square = polygon(box(0, 0, 1, 1));

TEST(Scaling, of_small_integers_is_trivial) {
  const Scaling scaling = scaling_of(unit_square, polygon(box(-5, -8, 3, 2)));
  EXPECT_TRUE(scaling.is_trivial());
  EXPECT_EQ(scaling.denominator, 1);
  EXPECT_EQ(scaling.bits, 4u) << "of 8";
  EXPECT_EQ(scaling.shift, 0u);
}

TEST(Scaling, denominator_is_the_least_common_one) {
  const Region sixths = polygon({{Rational(1, 6), 0}, {1, Rational(1, 4)}, {0, 1}});
  const Region tenths{{{box(0, 0, 3, 3), {backwards(box(1, 1, 2, Rational(19, 10)))}}}};
  EXPECT_EQ(scaling_of(sixths, unit_square).denominator, 12);
  EXPECT_EQ(scaling_of(unit_square, sixths).denominator, 12);
  const Scaling both = scaling_of(sixths, tenths);
  EXPECT_EQ(both.denominator, 60);
  EXPECT_EQ(both.bits, 8u) << "of 180";
  EXPECT_FALSE(both.is_trivial());
  EXPECT_EQ(scaled(Rational(1, 6), both, 0), 10);
  EXPECT_EQ(scaled(Rational(19, 10), both, 100), 14);
}

TEST(Scaling, looks_at_every_component_and_hole) {
  const Rational third(1, 3);
  const Region second{{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, third), {}}}};
  const Region in_hole{
      {{box(9, 0, 10, 1), {}}, {box(0, 0, 4, 4), {backwards(box(1, 1, 2, 1 + third))}}}};
  for (const Region& region : {second, in_hole}) {
    EXPECT_EQ(scaling_of(region, unit_square).denominator, 3);
    EXPECT_EQ(scaling_of(unit_square, region).denominator, 3);
  }
  const Region far{{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, 1000), {}}}};
  EXPECT_EQ(scaling_of(unit_square, far).bits, 10u);
}

TEST(Scaling, moves_only_where_29_bits_are_too_few) {
  const Rational limit = power_of_two(29);
  const Scaling stays = scaling_of(polygon(box(limit - 2, 0, limit - 1, 1)), unit_square);
  EXPECT_FALSE(stays.is_moved);
  EXPECT_TRUE(stays.is_trivial());
  EXPECT_EQ(stays.bits, 29u);

  const Scaling halves =
      scaling_of(polygon(box(limit / 2 - 2, 0, limit / 2 - 1, Rational(1, 2))), unit_square);
  EXPECT_FALSE(halves.is_moved);
  EXPECT_EQ(halves.denominator, 2);
  EXPECT_EQ(halves.bits, 29u);

  const Scaling moves =
      scaling_of(polygon(box(limit, 0, limit + 8, 6)), polygon(box(0, -9, 2, -1)));
  EXPECT_TRUE(moves.is_moved);
  EXPECT_FALSE(moves.is_trivial());
  EXPECT_EQ(moves.of_p.x, limit.get_num() + 4);
  EXPECT_EQ(moves.of_p.y, 3);
  EXPECT_EQ(moves.of_q.x, 1);
  EXPECT_EQ(moves.of_q.y, -5);
  EXPECT_EQ(moves.bits, 3u);
}

TEST(Scaling, never_has_more_bits_where_it_has_moved) {
  for (const int bits : {30, 124, 125, 300}) {
    const Rational m = power_of_two(bits) - 1;
    for (const auto& [low, high] : {std::pair<Rational, Rational>{-m, m},
                                    {-m, m - 1},
                                    {1 - m, m},
                                    {0, m},
                                    {-m, 0},
                                    {m - 1, m}}) {
      const Scaling scaling = scaling_of(polygon(box(low, low, high, high)), unit_square);
      EXPECT_LE(scaling.bits, static_cast<std::size_t>(bits)) << low << ' ' << high;
      EXPECT_LE(abs(scaled(low, scaling, scaling.of_p.x)), mpz_class(1) << scaling.bits);
      EXPECT_LE(abs(scaled(high, scaling, scaling.of_p.x)), mpz_class(1) << scaling.bits);
    }
  }
}

TEST(Scaling, shifts_doubles_to_60_bits) {
  const auto shift = [](int bits) {
    const Rational m = power_of_two(bits) - 1;
    return scaling_of(polygon(box(-m, -m, m, m)), unit_square).shift;
  };
  EXPECT_EQ(shift(29), 0u);
  EXPECT_EQ(shift(60), 0u);
  EXPECT_EQ(shift(61), 1u);
  EXPECT_EQ(shift(5000), 4940u);
}

/// A polygon with n denominators of the given number of bits, no two with a common factor.
Region with_denominators(std::size_t n, unsigned bits) {
  Chain chain{{0, 0}};
  mpz_class denominator = mpz_class(1) << bits;
  for (std::size_t k = 0; k < n; ++k) {
    mpz_nextprime(denominator.get_mpz_t(), denominator.get_mpz_t());
    const int x = static_cast<int>(k) + 1;
    chain.push_back({Rational(1, denominator) + x, x * x});
  }
  return polygon(chain);
}

TEST(Scaling, of_unlike_denominators_are_those_with_a_long_common_one) {
  const Region integers = polygon(box(0, 0, 9, 9));
  EXPECT_FALSE(has_unlike_denominators(integers, integers));
  EXPECT_FALSE(has_unlike_denominators(with_denominators(3, 32), integers));
  const Region unlike = with_denominators(40, 32);
  EXPECT_TRUE(has_unlike_denominators(unlike, integers));
  EXPECT_TRUE(has_unlike_denominators(integers, unlike));
  EXPECT_TRUE(has_unlike_denominators(with_denominators(3, 32), unlike));
  const Region large = polygon(box(0, 0, Rational(1, power_of_two(5000).get_num()), 9));
  EXPECT_FALSE(has_unlike_denominators(large, large));
}

TEST(Scaling, of_rationals_is_a_power_of_two) {
  for (const int exponent : {-300, -61, 0, 3, 61, 62, 63, 300}) {
    const Rational size = power_of_two(exponent) / 3;
    const Region p = polygon(box(-size, 0, size / 7, size / 5));
    const Scaling scaling = scaling_of_rationals(p, p);
    EXPECT_EQ(mpz_popcount(scaling.denominator.get_mpz_t()), 1u);
    EXPECT_FALSE(scaling.is_trivial());
    EXPECT_GE(scaling.bits, 62u) << "doubles are never exact";
    EXPECT_EQ(scaling.bits - scaling.shift, 60u);
    const Rational largest = size * scaling.denominator;
    EXPECT_LE(largest, power_of_two(static_cast<int>(scaling.bits)));
    EXPECT_GE(largest, power_of_two(static_cast<int>(scaling.bits) - 3));
  }
}

TEST(Scaling, puts_back) {
  const Rational far = power_of_two(40) / 3;
  const Region p = polygon({{far, 0}, {far + 1, Rational(1, 7)}, {far, 9}});
  const Region q = polygon({{0, -far}, {Rational(2, 5), -far}, {0, 1 - far}});
  const Scaling scaling = scaling_of(p, q);
  EXPECT_TRUE(scaling.is_moved);
  for (const Point& v : p.components[0].outer) {
    for (const Point& w : q.components[0].outer) {
      Point sum{scaled(v.x, scaling, scaling.of_p.x) + scaled(w.x, scaling, scaling.of_q.x),
                scaled(v.y, scaling, scaling.of_p.y) + scaled(w.y, scaling, scaling.of_q.y)};
      scaling.put_back(sum);
      EXPECT_EQ(sum, v + w);
    }
  }
}

}  // namespace
}  // namespace oplus::slide
