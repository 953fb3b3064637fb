// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/place_inside.hpp"

#include <gtest/gtest.h>

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

TEST(PlaceInside, of_gaps_that_no_double_can_tell) {
  for (const int exponent : {120, 600, 2000, 5000}) {
    const Rational gap = power_of_two(-exponent);
    for (const Rational& from : {Rational(0), Rational(1, 3), Rational(1 - gap)})
      expect_inside<AnyNumbers>(from, from + gap);
  }
  expect_inside<WideNumbers>(0, power_of_two(-124));
  expect_inside<WideNumbers>(1 - power_of_two(-124), 1);
}

}  // namespace
}  // namespace oplus::slide
