// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/point.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

TEST(Point, is_ordered_by_x_then_by_y) {
  EXPECT_LT((Point{0, 9}), (Point{1, 0}));
  EXPECT_LT((Point{1, 0}), (Point{1, Rational(1, 2)}));
  EXPECT_EQ((Point{1, 2} <=> Point{1, 2}), std::strong_ordering::equal);
}

TEST(Point, adds_like_a_vector) {
  const Point p{1, 2};
  const Point q{Rational(1, 3), -5};
  EXPECT_EQ(p + q, (Point{Rational(4, 3), -3}));
  EXPECT_EQ(p - q, (Point{Rational(2, 3), 7}));
  EXPECT_EQ(-p, (Point{-1, -2}));
  EXPECT_EQ(Rational(1, 2) * p, (Point{Rational(1, 2), 1}));
  EXPECT_EQ(midpoint(p, q), (Point{Rational(2, 3), Rational(-3, 2)}));
}

TEST(Point, cross_and_dot_are_the_skew_and_the_inner_product) {
  EXPECT_EQ(cross({3, 1}, {2, 5}), 13);
  EXPECT_EQ(cross({2, 5}, {3, 1}), -13);
  EXPECT_EQ(dot({3, 1}, {2, 5}), 11);
}

TEST(Point, orientation_is_that_of_the_turn) {
  EXPECT_EQ(orientation({0, 0}, {2, 0}, {1, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {2, 0}, {1, -1}), -1);
  EXPECT_EQ(orientation({0, 0}, {2, 0}, {7, 0}), 0);
}

TEST(Point, orientation_sees_what_doubles_do_not) {
  const Rational tiny = 1 / Rational("1" + std::string(400, '0'));
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {2, 2 + tiny}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {2, 2 - tiny}), -1);
}

TEST(Point, orientation_is_one_or_minus_one_for_numbers_of_any_length) {
  const Rational huge("1" + std::string(400, '0'));
  EXPECT_EQ(orientation({0, 0}, {huge, 0}, {0, huge}), 1);
  EXPECT_EQ(orientation({0, 0}, {0, huge}, {huge, 0}), -1);
  EXPECT_EQ(orientation({0, 0}, {1 / huge, 0}, {huge, huge}), 1);
}

}  // namespace
}  // namespace oplus
