// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "checked/oplus/oplus.hpp"
#include "tests/reference/io/refusal.hpp"

namespace oplus {
namespace {

/// What refuses a value says.
template <typename T>
std::string message_of(const T& value) {
  return refusal([&] { Number{value}; });
}

Rational power_of_two(int exponent) {
  const mpz_class power = mpz_class(1) << static_cast<mp_bitcnt_t>(std::abs(exponent));
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

TEST(Number, takes_integers_of_all_sizes) {
  EXPECT_EQ(Number(std::int8_t{-128}).value(), -128);
  EXPECT_EQ(Number(std::uint8_t{255}).value(), 255);
  EXPECT_EQ(Number(std::int16_t{-32768}).value(), -32768);
  EXPECT_EQ(Number(std::numeric_limits<std::int32_t>::min()).value(), Rational("-2147483648"));
  EXPECT_EQ(Number(std::numeric_limits<std::uint32_t>::max()).value(), Rational("4294967295"));
  EXPECT_EQ(Number(INT64_MIN).value(), Rational("-9223372036854775808"));
  EXPECT_EQ(Number(INT64_MIN + 1).value(), Rational("-9223372036854775807"));
  EXPECT_EQ(Number(INT64_MAX).value(), Rational("9223372036854775807"));
  EXPECT_EQ(Number(UINT64_MAX).value(), Rational("18446744073709551615"));
  EXPECT_EQ(Number(0LL).value(), 0);
}

TEST(Number, takes_doubles_for_exactly_what_they_are) {
  EXPECT_EQ(Number(0.5).value(), Rational(1, 2));
  EXPECT_EQ(Number(0.1).value(), Rational("3602879701896397/36028797018963968"));
  EXPECT_EQ(Number(0.1F).value(), Rational(13421773, 134217728));
  EXPECT_EQ(Number(-0.0).value(), 0);
  EXPECT_EQ(Number(std::numeric_limits<double>::denorm_min()).value(), power_of_two(-1074));
  EXPECT_EQ(Number(-DBL_MAX).value(), power_of_two(971) - power_of_two(1024));
}

TEST(Number, refuses_what_is_not_finite) {
  for (const double value : {HUGE_VAL, -HUGE_VAL, std::nan("")})
    EXPECT_EQ(message_of(value),
              "coordinate: the double is infinite or not a number; expected a finite one");
}

TEST(Number, brings_rationals_into_lowest_terms) {
  Rational value;
  value.get_num() = -2;
  value.get_den() = 4;
  EXPECT_EQ(Number(value).value().get_str(), "-1/2");
  value.get_num() = 3;
  value.get_den() = -6;
  EXPECT_EQ(Number(value).value().get_str(), "-1/2");
  EXPECT_EQ(Number(mpz_class(7)).value(), 7);
  EXPECT_EQ(Number(Rational(1, 3) + mpz_class(2)).value(), Rational(7, 3));
  for (const int numerator : {0, 1, -5}) {
    value.get_num() = numerator;
    value.get_den() = 0;
    EXPECT_EQ(message_of(value), "coordinate: the denominator is zero; expected a rational number");
  }
}

TEST(Number, reads_text) {
  const char* const decimal = "0.1";
  EXPECT_EQ(Number(decimal).value(), Rational(1, 10));
  EXPECT_EQ(Number("-2/4").value().get_str(), "-1/2");
  EXPECT_EQ(Number(std::string("1.5e-3")).value(), Rational(3, 2000));
  EXPECT_EQ(Number(std::string_view("7")).value(), 7);
  for (const std::string text : {"", "x", "1/0", "nan", "1 2", "1e999999"}) {
    const std::string message = message_of(text);
    EXPECT_EQ(message.find("coordinate: "), 0U) << text << ": " << message;
    EXPECT_NE(message.find("; expected "), std::string::npos) << text << ": " << message;
  }
  static_assert(!std::constructible_from<Number, std::nullptr_t>);
  static_assert(!std::constructible_from<Number, long double>);
}

TEST(Coordinates, are_two_numbers_of_any_kind) {
  struct Own {
    float x;
    const char* y;
  };
  const Point expected = {Rational(1, 2), 3};
  EXPECT_EQ(Coordinates(0.5, "3").point(), expected);
  EXPECT_EQ(Coordinates(Own{0.5F, "3"}).point(), expected);
  EXPECT_EQ(Coordinates(std::pair(0.5, 3U)).point(), expected);
  EXPECT_EQ(Coordinates(std::array<std::string, 2>{"1/2", "3"}).point(), expected);
  EXPECT_EQ(Coordinates(expected).point(), expected);
  Point raw;
  raw.x.get_den() = 0;
  EXPECT_THROW(Coordinates{raw}, InvalidInput);
  static_assert(!std::constructible_from<Coordinates, std::array<int, 3>>);
}

/// Whether no double is nearer to the value, and of two that are as near the even one was chosen.
testing::AssertionResult is_nearest(const Rational& value) {
  const double result = to_double(value);
  if (std::isinf(result))
    // Half of the way from the largest double to 2^1024, where the tie goes to 2^1024.
    return abs(value) >= power_of_two(1024) - power_of_two(970) && (result > 0) == (value > 0)
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << value << " is not infinite";
  int exponent = 0;
  const double mantissa = std::frexp(result, &exponent);
  // The last bit of a subnormal number is that of the smallest.
  const int last_bit = std::max(exponent - DBL_MANT_DIG, -1074);
  const bool is_even = std::fmod(std::ldexp(mantissa, exponent - last_bit), 2) == 0;
  const Rational distance = abs(value - Rational(result));
  for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
    const double next = std::nextafter(result, towards);
    const Rational other =
        abs(value - (std::isinf(next) ? sgn(value) * power_of_two(1024) : Rational(next)));
    if (distance > other || (distance == other && !is_even))
      return testing::AssertionFailure() << value << ": " << next << " is nearer than " << result;
  }
  return testing::AssertionSuccess();
}

TEST(ToDouble, returns_the_nearest) {
  std::mt19937_64 random(1);
  std::size_t subnormal = 0;
  std::size_t infinite = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto number = [&] { return mpz_class(std::to_string(random() >> random() % 64)); };
    const int exponent = i % 4 == 0 ? 0 : static_cast<int>(random() % 2300) - 1150;
    Rational value = Rational(number(), number() + 1) * power_of_two(exponent);
    value.canonicalize();
    if (random() % 2 == 0) value = -value;
    ASSERT_TRUE(is_nearest(value));
    const double result = std::abs(to_double(value));
    if (std::isinf(result)) ++infinite;
    if (result < DBL_MIN) ++subnormal;
  }
  EXPECT_GT(subnormal, 500U);
  EXPECT_GT(infinite, 500U);
}

TEST(ToDouble, rounds_ties_to_even) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 2'000; ++i) {
    double below = std::ldexp(static_cast<double>(random() % (1ULL << 53)),
                              static_cast<int>(random() % 2040) - 1074);
    if (i % 4 == 0) below = static_cast<double>(random() % 1000) * 0x1p-1074;
    const Rational tie = (Rational(below) + Rational(std::nextafter(below, HUGE_VAL))) / 2;
    for (const Rational& value : {tie, Rational(-tie)}) ASSERT_TRUE(is_nearest(value));
  }
  EXPECT_EQ(to_double(Rational(mpz_class("9007199254740993"))), 0x1p53);
  EXPECT_EQ(to_double(Rational(mpz_class("9007199254740995"))), 0x1p53 + 4);
  EXPECT_EQ(to_double(power_of_two(-1075)), 0);
  EXPECT_EQ(to_double(power_of_two(-1075) * 3), 0x1p-1073);
}

TEST(ToDouble, is_infinite_beyond_the_largest) {
  const Rational tie = power_of_two(1024) - power_of_two(970);
  EXPECT_EQ(to_double(tie - power_of_two(-1074)), DBL_MAX);
  EXPECT_EQ(to_double(tie), HUGE_VAL);
  EXPECT_EQ(to_double(Rational(-tie)), -HUGE_VAL);
  EXPECT_EQ(to_double(power_of_two(5000)), HUGE_VAL);
}

TEST(ToDouble, returns_both_coordinates_of_a_point) {
  EXPECT_EQ(to_double(Point{Rational(1, 3), -2}), (std::array<double, 2>{1.0 / 3, -2}));
}

}  // namespace
}  // namespace oplus
