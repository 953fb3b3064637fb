// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/place_inside.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "reference/families/random.hpp"
#include "tests/checked/slide/exact_values.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers>
class PlaceInside : public testing::Test {};
TYPED_TEST_SUITE(PlaceInside, AllNumbers);

template <typename Numbers>
Piece<Numbers> piece(const Rational& from, const Rational& to) {
  return {fraction<Numbers>(from.get_num(), from.get_den()),
          fraction<Numbers>(to.get_num(), to.get_den())};
}

/// A place strictly inside. Returns its denominator.
template <typename Numbers>
mpz_class expect_inside(const Rational& from, const Rational& to) {
  const Fraction<Numbers> t = place_inside(piece<Numbers>(from, to));
  EXPECT_LT(from, place_of(t));
  EXPECT_LT(place_of(t), to);
  return integer(t.denominator());
}

TYPED_TEST(PlaceInside, of_a_whole_segment_is_its_middle) {
  const Fraction<TypeParam> t = place_inside(piece<TypeParam>(0, 1));
  EXPECT_EQ(place_of(t), Rational(1, 2));
}

TYPED_TEST(PlaceInside, of_two_neighbouring_fractions_of_60_bits) {
  // Fibonacci's numbers: each two quotients in a row differ by one over the product.
  mpz_class a = 0, b = 1;
  while (mpz_sizeinbase(b.get_mpz_t(), 2) < 60) {
    const mpz_class c = a + b;
    a = b;
    b = c;
    Rational low(a, b), high(b, a + b);
    if (high < low) std::swap(low, high);
    ASSERT_EQ(high - low, Rational(1, mpz_class(b * (a + b))));
    expect_inside<TypeParam>(low, high);
  }
  const Rational almost(mpz_class(b - 1), b);
  expect_inside<TypeParam>(almost, 1);
  expect_inside<TypeParam>(0, 1 - almost);
}

TYPED_TEST(PlaceInside, of_gaps_as_narrow_as_doubles_can_barely_tell) {
  Random random(4);
  for (int exponent = 1; exponent <= 58; ++exponent) {
    for (int k = 0; k < 50; ++k) {
      // About as wide as 2^-exponent, anywhere from 0 to 1.
      const mpz_class d = (mpz_class(1) << 59) - uniform(random, 0, 1000000);
      mpz_class wide = d >> static_cast<unsigned>(exponent);
      wide += uniform(random, 0, 3) * (wide / 4);
      const mpz_class low = (d - wide) * uniform(random, 0, 1000) / 1000;
      const Rational from = Rational(low) / d;
      const Rational to = Rational(low + std::max<mpz_class>(wide, 1)) / d;
      const mpz_class denominator = expect_inside<TypeParam>(from, to);
      if (exponent < 38) {
        EXPECT_LE(denominator, mpz_class(1) << 42) << "in short numbers";
      }
    }
  }
}

TEST(PlaceInside, of_gaps_that_no_double_can_tell) {
  for (const int exponent : {120, 600, 2000, 5000}) {
    const Rational gap = power_of_two(-exponent);
    for (const Rational& from : {Rational(0), Rational(1, 3), Rational(1 - gap)})
      expect_inside<AnyNumbers>(from, from + gap);
  }
  expect_inside<WideNumbers>(0, power_of_two(-250));
  expect_inside<WideNumbers>(1 - power_of_two(-250), 1);
}

}  // namespace
}  // namespace oplus::slide
