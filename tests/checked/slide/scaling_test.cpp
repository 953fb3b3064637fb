// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/scaling.hpp"

#include <gtest/gtest.h>

#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::slide {
namespace {

const Region unit_square = polygon(box(0, 0, 1, 1));

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

}  // namespace
}  // namespace oplus::slide
