// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/oplus/number_types.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <boost/rational.hpp>
#include <cmath>

namespace oplus {
namespace {

namespace mp = boost::multiprecision;

template <typename T>
constexpr bool is_rational = NumberConversion<T>::is_rational;
static_assert(is_rational<float> && is_rational<double> && is_rational<int>);
static_assert(is_rational<mpq_class> && is_rational<mpz_class>);
static_assert(is_rational<mp::cpp_rational> && is_rational<mp::mpq_rational>);
static_assert(is_rational<mp::cpp_int> && is_rational<mp::mpz_int> && is_rational<mp::int128_t>);
static_assert(is_rational<boost::rational<int>> && is_rational<boost::rational<mp::cpp_int>>);
static_assert(!is_rational<long double> && !is_rational<mp::cpp_dec_float_50>);
static_assert(!is_rational<std::string> && !is_rational<const char*>);

/// Returns the text of a number that was converted and back.
template <typename T>
std::string there_and_back(const std::string& text) {
  return NumberConversion<T>::exact(NumberConversion<T>::nearest(Rational(text))).get_str();
}

template <typename T>
class Fraction : public testing::Test {};
using Fractions =
    testing::Types<mpq_class, mp::cpp_rational, mp::mpq_rational,
                   mp::number<mp::cpp_rational_backend, mp::et_off>, boost::rational<mp::cpp_int>>;
TYPED_TEST_SUITE(Fraction, Fractions);

TYPED_TEST(Fraction, is_exact) {
  for (const std::string text : {"0", "-1", "1/3", "-2/7", "123456789012345678901234567891/7",
                                 "5/340282366920938463463374607431768211456"})
    EXPECT_EQ(there_and_back<TypeParam>(text), text);
}

template <typename T>
class Integer : public testing::Test {};
using Integers = testing::Types<short, int, unsigned, std::int64_t, std::uint64_t, mpz_class,
                                mp::cpp_int, mp::mpz_int, mp::int128_t, boost::rational<int>>;
TYPED_TEST_SUITE(Integer, Integers);

TYPED_TEST(Integer, is_exact) {
  for (const std::string text : {"0", "7", "12345"})
    EXPECT_EQ(there_and_back<TypeParam>(text), text);
}

template <typename T>
std::string refusal(const std::string& text) {
  try {
    return there_and_back<T>(text);
  } catch (const std::domain_error& error) {
    return error.what();
  }
}

TEST(Integers, refuse_fractions) {
  const std::string expected = "coordinate -1/3: the integer type cannot hold it";
  EXPECT_EQ(refusal<int>("-1/3"), expected);
  EXPECT_EQ(refusal<mpz_class>("-1/3"), expected);
  EXPECT_EQ(refusal<mp::cpp_int>("-1/3"), expected);
}

TEST(Integers, refuse_what_is_too_large) {
  EXPECT_EQ(refusal<std::int8_t>("-128"), "-128");
  EXPECT_EQ(refusal<std::int64_t>("-9223372036854775808"), "-9223372036854775808");
  EXPECT_EQ(refusal<std::uint64_t>("18446744073709551615"), "18446744073709551615");
  EXPECT_EQ(refusal<mp::int128_t>("-1267650600228229401496703205376"),
            "-1267650600228229401496703205376");
  EXPECT_EQ(refusal<std::int8_t>("128"), "coordinate 128: the integer type cannot hold it");
  EXPECT_EQ(refusal<unsigned>("-1"), "coordinate -1: the integer type cannot hold it");
  EXPECT_EQ(refusal<std::uint64_t>("18446744073709551616"),
            "coordinate 18446744073709551616: the integer type cannot hold it");
  EXPECT_EQ(refusal<boost::rational<int>>("1/2147483648"),
            "coordinate 2147483648: the integer type cannot hold it");
  const std::string large = "1" + std::string(60, '0');
  EXPECT_EQ(refusal<mp::int128_t>(large),
            "coordinate " + large + ": the integer type cannot hold it");
}

TEST(FloatingPoint, is_taken_exactly_and_made_by_rounding) {
  EXPECT_EQ(NumberConversion<double>::exact(0.1), Number(0.1).value());
  EXPECT_EQ(NumberConversion<double>::nearest(Rational(1, 3)), 1.0 / 3);
  EXPECT_EQ(NumberConversion<float>::nearest(Rational(1, 3)), 1.0F / 3);
  EXPECT_THROW(NumberConversion<double>::exact(HUGE_VAL), InvalidInput);
  EXPECT_THROW(NumberConversion<float>::exact(std::nanf("")), InvalidInput);
}

TEST(Rationals, may_be_raw) {
  Rational raw;
  raw.get_num() = 2;
  raw.get_den() = 4;
  EXPECT_EQ(NumberConversion<Rational>::exact(raw).get_str(), "1/2");
  raw.get_den() = 0;
  EXPECT_THROW(NumberConversion<Rational>::exact(raw), InvalidInput);
}

/// A number type of a user.
struct Cents {
  int value;
};

}  // namespace

template <>
struct NumberConversion<Cents> {
  static constexpr bool is_rational = true;
  static Rational exact(const Cents& cents) { return Number(cents.value).value() / 100; }
  static Cents nearest(const Rational& value) {
    return {NumberConversion<int>::nearest(value * 100)};
  }
};

namespace {

TEST(NumberConversion, may_be_specialized) {
  static_assert(NumberConversion<Cents>::is_rational);
  EXPECT_EQ(there_and_back<Cents>("1/4"), "1/4");
  EXPECT_EQ(refusal<Cents>("1/3"), "coordinate 100/3: the integer type cannot hold it");
}

}  // namespace
}  // namespace oplus
