// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/arithmetic/rational_rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/io/power_of_ten.hpp"

namespace oplus {
namespace {

Rational tenth_to_the(unsigned long digits) { return Rational(1, power_of_ten(digits)); }

double degrees_by_libm(const RationalRotation& r) {
  return std::atan2(r.sin.get_d(), r.cos.get_d()) * 180 / std::numbers::pi;
}

bool is_rotation(const RationalRotation& r) { return r.cos * r.cos + r.sin * r.sin == 1; }

/// From -180 to 180, both ends standing for the same.
double turned_to(double degrees) { return std::remainder(degrees, 360); }

TEST(RationalRotation, meets_multiples_of_90_degrees) {
  const RationalRotation turns[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int i = -9; i < 9; ++i) {
    EXPECT_EQ(rational_rotation(90 * i, 1), turns[(i + 12) % 4]) << i;
    EXPECT_EQ(rational_rotation(90 * i, tenth_to_the(50)), turns[(i + 12) % 4]) << i;
  }
}

TEST(RationalRotation, is_a_rotation_within_the_error) {
  for (int thirds = -1100; thirds < 1100; thirds += 7) {
    const Rational degrees = Rational(thirds) / 3;
    for (const unsigned long digits : {0UL, 1UL, 4UL, 9UL}) {
      const RationalRotation r = rational_rotation(degrees, tenth_to_the(digits));
      ASSERT_TRUE(is_rotation(r)) << degrees;
      ASSERT_LE(std::abs(turned_to(degrees_by_libm(r) - degrees.get_d())),
                std::pow(10, -static_cast<double>(digits)) + 1e-12)
          << degrees;
    }
  }
}

TEST(RationalRotation, by_the_opposite_angle_is_the_inverse) {
  for (int degrees = 0; degrees < 400; degrees += 5) {
    const RationalRotation there = rational_rotation(degrees, tenth_to_the(5));
    EXPECT_EQ(rational_rotation(-degrees, tenth_to_the(5)),
              (RationalRotation{there.cos, -there.sin}));
  }
}

/// The smallest length of a Pythagorean triangle with such an angle, by trying all.
int smallest_denominator(int degrees, double error) {
  const double sine = std::sin(degrees * std::numbers::pi / 180);
  for (std::int64_t c = 1;; ++c) {
    const std::int64_t middle = std::llround(static_cast<double>(c) * sine);
    for (auto b = std::max<std::int64_t>(middle - 40, 0); b <= std::min(middle + 40, c); ++b) {
      const std::int64_t a = std::llround(std::sqrt(static_cast<double>(c * c - b * b)));
      const double angle =
          std::atan2(static_cast<double>(b), static_cast<double>(a)) * 180 / std::numbers::pi;
      if (a * a + b * b == c * c && std::abs(angle - degrees) <= error) return static_cast<int>(c);
    }
  }
}

TEST(RationalRotation, has_the_smallest_denominator) {
  for (int degrees = 1; degrees < 90; degrees += 4) {
    const RationalRotation r = rational_rotation(degrees, Rational(1, 100));
    EXPECT_EQ(r.cos.get_den(), smallest_denominator(degrees, 0.01)) << degrees;
    EXPECT_EQ(r.sin.get_den(), r.cos.get_den());
  }
}

TEST(RationalRotation, takes_any_error) {
  EXPECT_EQ(rational_rotation(44, 100), RationalRotation{});
  const RationalRotation r = rational_rotation(30, tenth_to_the(300));
  EXPECT_TRUE(is_rotation(r));
  // sin 30° = 1/2, and its slope there is below 1 / radian.
  EXPECT_LT(abs(r.sin - Rational(1, 2)), tenth_to_the(300) / 57);
  EXPECT_GT(r.cos, Rational(866, 1000));
}

TEST(AngleInDegrees, is_what_libm_says) {
  for (int i = -1080; i < 1080; ++i) {
    const RationalRotation r = rational_rotation(Rational(i) / 3, tenth_to_the(6));
    EXPECT_NEAR(angle_in_degrees(r, tenth_to_the(15)).get_d(), degrees_by_libm(r), 1e-12) << i;
  }
  EXPECT_EQ(angle_in_degrees({-1, 0}, 1), 180);
  EXPECT_EQ(angle_in_degrees({0, -1}, 1), -90);
}

TEST(AngleInDegrees, is_within_the_error_for_many_digits) {
  for (const int degrees : {7, 45, 100, -170}) {
    const RationalRotation r = rational_rotation(degrees, tenth_to_the(80));
    EXPECT_LE(abs(angle_in_degrees(r, tenth_to_the(90)) - degrees),
              tenth_to_the(80) + tenth_to_the(90));
  }
}

}  // namespace
}  // namespace oplus
