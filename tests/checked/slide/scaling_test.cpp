// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/scaling.hpp"

#include <gtest/gtest.h>

#include "checked/operations/complement.hpp"
#include "checked/slide/slide.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::slide {
namespace {

/// A common denominator of its coordinates is long.
Region unlike() {
  Chain chain;
  for (int i = 0; i < 6; ++i)
    chain.push_back({i + Rational(1, power_of_two(60).get_num() + 2 * i + 1), i * i});
  return polygon(chain);
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

TEST(Extent, is_of_all_chains_of_unbounded_regions_too) {
  const Region p = polygon(box(1, 2, Rational(7, 2), Rational(13, 3)));
  for (const Region& region : {p, complement(p)}) {
    const Extent extent = extent_of(region);
    EXPECT_EQ(extent.low, (Point{1, 2}));
    EXPECT_EQ(extent.high, (Point{Rational(7, 2), Rational(13, 3)}));
    EXPECT_EQ(extent.denominator, 6);
  }
  EXPECT_EQ(extent_of({}).high, (Point{0, 0}));
}

TEST(Extent, is_unlike_where_a_common_denominator_is_long) {
  EXPECT_TRUE(extent_of(unlike(), Denominators::alike).is_unlike);
  EXPECT_FALSE(extent_of(unlike(), Denominators::any).is_unlike);
  EXPECT_TRUE(has_unlike_denominators(extent_of(unlike(), Denominators::any), {}));
}

TEST(Scaling, of_sums_in_which_either_summand_has_unlike_denominators) {
  const Region square = polygon(box(0, 0, 1, 1)), other = unlike();
  const PlanarSet sum = slide_sum(square, other, Boundary::closed).sum;
  for (const auto& [p, q] : {std::pair(&other, &square), {&square, &other}})
    for (const SlideNumbers numbers : {SlideNumbers::as_needed, SlideNumbers::gmp})
      EXPECT_EQ(sum, slide_sum(*p, *q, Boundary::closed, {.numbers = numbers}).sum);
  EXPECT_EQ(sum.outer.at(0).front(), other.components[0].outer[0]);
}

}  // namespace
}  // namespace oplus::slide
