// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/number.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace oplus {
namespace {

TEST(Number, is_read_exactly) {
  const std::vector<std::pair<std::string, Rational>> cases{
      {"0", 0},
      {"-0", 0},
      {"+7", 7},
      {"007", 7},
      {"-12", -12},
      {"0.1", Rational(1, 10)},
      {"-.5", Rational(-1, 2)},
      {"5.", 5},
      {"1.50", Rational(3, 2)},
      {"1.5e-3", Rational(3, 2000)},
      {"1.5E+3", 1500},
      {"-2e0002", -200},
      {"0e4096", 0},
      {"6/4", Rational(3, 2)},
      // As many digits as an integer of 64 bits holds for certain, one more, and many more.
      {"999999999.9999999999", Rational("9999999999999999999/10000000000")},
      {"-0.0000000000000000005", Rational("-1/2000000000000000000")},
      {"99999999999999999999", Rational("99999999999999999999")},
      {"-18446744073709551616.5", Rational("-36893488147419103233/2")},
      {"-1/3", Rational(-1, 3)},
      {"0/5", 0},
      {"90000000000000000000000000000001/3", Rational("90000000000000000000000000000001/3")},
  };
  for (const auto& [text, value] : cases) {
    NumberFault fault;
    const std::optional<Rational> read = parse_number(text, fault);
    ASSERT_TRUE(read) << text << ": " << fault.wrong;
    EXPECT_EQ(*read, value) << text;
  }
}

TEST(Number, is_in_lowest_terms) {
  NumberFault fault;
  EXPECT_EQ(parse_number("0.50", fault)->get_den(), 2);
  EXPECT_EQ(parse_number("25e-2", fault)->get_den(), 4);
  EXPECT_EQ(parse_number("10/5", fault)->get_den(), 1);
}

TEST(Number, of_the_largest_exponents_is_exact) {
  NumberFault fault;
  const std::optional<Rational> large = parse_number("1e4096", fault);
  const std::optional<Rational> small = parse_number("1e-4096", fault);
  ASSERT_TRUE(large && small);
  EXPECT_EQ(large->get_str(), "1" + std::string(4096, '0'));
  EXPECT_EQ(*large * *small, 1);
}

/// Texts that are not numbers, each refused as "'text' " + wrong.
struct Refused {
  std::string wrong;
  std::string expected;
  std::vector<std::string> texts;
};

TEST(Number, that_is_invalid_is_refused_with_the_reason) {
  const std::vector<Refused> all{
      {"is not a number",
       "an integer, a decimal or a fraction p/q",
       {"",      "-",     "+",     ".",   "e5", "1e",  "1e+",  "1.5.2", "1e5e5",
        "1,5",   "0x10",  "1_000", "--1", "1/", "/2",  "1/-2", "1/2/3", "1.5/2",
        "1/2.5", "1e1/2", "1 2",   " 1",  "1 ", "abc", "nano"}},
      {"is not finite", "a finite number", {"nan", "-NaN", "inf", "+inf", "-Infinity"}},
      {"has the denominator 0", "a fraction p/q with q > 0", {"1/0", "0/0", "-7/000"}},
      {"has too large an exponent",
       "an exponent from -4096 to 4096",
       {"1e4097", "1e-4097", "0e99999999999999999999"}},
  };
  for (const Refused& refused : all) {
    for (const std::string& text : refused.texts) {
      NumberFault fault;
      EXPECT_FALSE(parse_number(text, fault)) << text;
      EXPECT_EQ(fault.wrong, "'" + text + "' " + refused.wrong);
      EXPECT_EQ(fault.expected, refused.expected);
    }
  }
}

}  // namespace
}  // namespace oplus
