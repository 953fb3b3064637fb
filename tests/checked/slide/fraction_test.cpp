// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/fraction.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/checked/slide/exact_values.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers>
class FractionIn : public testing::Test {};
TYPED_TEST_SUITE(FractionIn, AllNumbers);

template <typename Numbers>
void expect_less(const Fraction<Numbers>& a, const Fraction<Numbers>& b) {
  EXPECT_TRUE(a < b) << place_of(a) << ' ' << place_of(b);
  EXPECT_FALSE(b < a) << place_of(a) << ' ' << place_of(b);
}

template <typename Numbers>
void expect_equal(const Fraction<Numbers>& a, const Fraction<Numbers>& b) {
  EXPECT_FALSE(a < b) << place_of(a) << ' ' << place_of(b);
  EXPECT_FALSE(b < a) << place_of(a) << ' ' << place_of(b);
}

TYPED_TEST(FractionIn, a_sum_too_small_for_doubles_is_ordered) {
  Random random(1);
  for (unsigned half = bits<TypeParam> / 2 - 10; half <= bits<TypeParam> / 2 - 1; ++half) {
    for (const int sign : {1, -1}) {
      const mpz_class n = sign * odd_number(random, half), d = odd_number(random, half);
      const mpz_class k = odd_number(random, half);
      const auto reduced = fraction<TypeParam>(n, d);
      expect_equal(reduced, fraction<TypeParam>(n * k, d * k));
      expect_less(reduced, fraction<TypeParam>(n * k + 1, d * k));
      expect_less(fraction<TypeParam>(n * k - 1, d * k), reduced);
      expect_less(fraction<TypeParam>(n * k - 1, d * k), fraction<TypeParam>(n * k + 1, d * k));
    }
  }
}

TYPED_TEST(FractionIn, huge_and_tiny_values_are_ordered) {
  const mpz_class huge = (mpz_class(1) << bits<TypeParam>)-1;
  const std::vector<Fraction<TypeParam>> ascending{
      fraction<TypeParam>(-huge, 1),       fraction<TypeParam>(1 - huge, 1),
      fraction<TypeParam>(-huge, 2),       fraction<TypeParam>(-1, 1),
      fraction<TypeParam>(1 - huge, huge), fraction<TypeParam>(-1, 2),
      fraction<TypeParam>(-1, huge - 1),   fraction<TypeParam>(-1, huge),
      fraction<TypeParam>(0, huge),        fraction<TypeParam>(1, huge),
      fraction<TypeParam>(1, huge - 1),    fraction<TypeParam>(1, 2),
      fraction<TypeParam>(huge - 1, huge), fraction<TypeParam>(1, 1),
      fraction<TypeParam>(huge, huge - 1), fraction<TypeParam>(huge - 1, 1),
      fraction<TypeParam>(huge, 1)};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    expect_equal(ascending[i], ascending[i]);
    for (std::size_t j = i + 1; j < ascending.size(); ++j) expect_less(ascending[i], ascending[j]);
  }
  expect_equal(fraction<TypeParam>(0, 1), fraction<TypeParam>(0, huge));
  expect_equal(fraction<TypeParam>(1, 1), fraction<TypeParam>(huge, huge));
}

TYPED_TEST(FractionIn, order_is_that_of_rationals) {
  Random random(2);
  for (int k = 0; k < 2000; ++k) {
    const auto size = [&] { return static_cast<unsigned>(uniform(random, 1, bits<TypeParam>)); };
    const auto any = [&] {
      const mpz_class n = odd_number(random, size()) * uniform(random, -1, 1);
      return fraction<TypeParam>(n, odd_number(random, size()));
    };
    const auto a = any(), b = any();
    EXPECT_EQ(a < b, place_of(a) < place_of(b)) << place_of(a) << ' ' << place_of(b);
  }
}

TYPED_TEST(FractionIn, near_is_within_its_bound) {
  Random random(3);
  for (int k = 0; k < 2000; ++k) {
    const auto size = [&] { return static_cast<unsigned>(uniform(random, 1, bits<TypeParam>)); };
    const mpz_class n = odd_number(random, size()) * uniform(random, -1, 1);
    // No double is larger than 2^1024.
    const auto length = static_cast<unsigned>(mpz_sizeinbase(n.get_mpz_t(), 2));
    const unsigned least = std::max(length, 1000u) - 999;
    const auto t = fraction<TypeParam>(n, odd_number(random, std::max(size(), least)));
    const Rational exact = place_of(t);
    const Rational bound = std::max(Rational(abs(exact) * power_of_two(-50)), power_of_two(-1000));
    EXPECT_LE(abs(Rational(t.near()) - exact), bound) << exact;
  }
}

/// Boost's own shift makes some of these positive (docs/findings.md).
TYPED_TEST(FractionIn, negative_numbers_are_scaled_down_to_negative_ones) {
  using Value = typename TypeParam::Value;
  const int most = static_cast<int>(std::min(bits<TypeParam>, 300u));
  for (int k = 1; k < most - 1; ++k) {
    Value value = 1;
    for (int i = 0; i < k; ++i) value = value + value;
    for (const int more : {-1, 0, 1}) {
      const double expected = -std::ldexp(1.0, k - 16);
      const double got = scaled_down(Value(-value - more), 16);
      // Off by one in 2^16, and by a rounding.
      EXPECT_LE(std::abs(got - expected), 0x1p-15 - 0x1p-50 * expected) << k;
      EXPECT_EQ(scaled_down(Value(value + more), 16), -got) << k;
    }
  }
}

}  // namespace
}  // namespace oplus::slide
