// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/numbers.hpp"

#include <gtest/gtest.h>

namespace oplus {
namespace {

TEST(BenchNumbers, have_three_digits_and_separated_thousands) {
  EXPECT_EQ(three_digits(0), "0");
  EXPECT_EQ(three_digits(0.012345), "0.0123");
  EXPECT_EQ(three_digits(1.2), "1.20");
  EXPECT_EQ(three_digits(99.96), "100");
  EXPECT_EQ(three_digits(9.996), "10.0");
  EXPECT_EQ(three_digits(0.9999), "1.00");
  EXPECT_EQ(three_digits(100), "100");
  EXPECT_EQ(three_digits(1), "1.00");
  EXPECT_EQ(three_digits(1000), "1,000");
  EXPECT_EQ(three_digits(12345), "12,300");
  EXPECT_EQ(three_digits(-1234567), "-1,230,000");
  EXPECT_EQ(three_digits(-123), "-123");
}

TEST(BenchNumbers, plain) {
  EXPECT_EQ(plain(60), "60");
  EXPECT_EQ(plain(0.25), "0.25");
}

TEST(BenchNumbers, as_powers_of_ten) {
  EXPECT_EQ(power_of_ten(0), "0");
  EXPECT_EQ(power_of_ten(-0.0000123), "-1.2e-05");
}

TEST(BenchNumbers, with_separated_thousands) {
  EXPECT_EQ(with_thousands(0), "0");
  EXPECT_EQ(with_thousands(999), "999");
  EXPECT_EQ(with_thousands(1000), "1,000");
  EXPECT_EQ(with_thousands(1234567), "1,234,567");
}

}  // namespace
}  // namespace oplus
