// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/scaling.hpp"

#include <gtest/gtest.h>

#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::slide {
namespace {

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
