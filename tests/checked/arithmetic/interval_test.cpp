// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arithmetic/interval.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace oplus {
namespace {

const Rational huge("1" + std::string(400, '0'));

TEST(IntervalStage, contains_its_number) {
  for (const Rational& value :
       {Rational(1, 3), Rational(-2, 7), Rational(1 / huge), Rational(-1 / huge)}) {
    const Interval around = interval(value);
    EXPECT_LT(Rational(around.inf()), value);
    EXPECT_GT(Rational(around.sup()), value);
  }
  EXPECT_EQ(interval(Rational(3, 4)).inf(), 0.75);
  EXPECT_EQ(interval(Rational(3, 4)).sup(), 0.75);
  EXPECT_EQ(interval(huge).sup(), std::numeric_limits<double>::infinity());
  EXPECT_LT(Rational(interval(huge).inf()), huge);
}

CGAL::Uncertain<CGAL::Sign> turn(const Point& a, const Point& b, const Point& c) {
  const CGAL::Protect_FPU_rounding<true> rounding;
  return orientation(interval(a), interval(b), interval(c));
}

TEST(IntervalStage, must_answer_for_small_integers) {
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      const auto sign = turn({-2, -1}, {3, 2}, {x, y});
      ASSERT_TRUE(CGAL::is_certain(sign));
      EXPECT_EQ(static_cast<int>(sign.inf()), orientation(Point{-2, -1}, Point{3, 2}, Point{x, y}));
    }
  }
}

TEST(IntervalStage, must_not_answer_where_doubles_cannot_tell) {
  const Rational third(1, 3);
  EXPECT_FALSE(CGAL::is_certain(turn({0, 0}, {third, third}, {2 * third, 2 * third})));
  EXPECT_FALSE(CGAL::is_certain(turn({0, 0}, {1, 1}, {2, 2 + 1 / huge})));
  EXPECT_FALSE(CGAL::is_certain(turn({0, 0}, {huge, huge}, {huge, huge + 1})));
}

TEST(IntervalStage, answers_rightly_or_not_at_all_beyond_doubles) {
  const std::vector<Point> points{{0, 0},        {huge, 0},        {0, -huge},
                                  {1, 0},        {0, 1},           {huge, huge},
                                  {-huge, huge}, {1 / huge, 0},    {0, 1 / huge},
                                  {1 / huge, 1}, {huge, 1 / huge}, {-1 / huge, -huge}};
  for (const Point& a : points) {
    for (const Point& b : points) {
      for (const Point& c : points) {
        const auto sign = turn(a, b, c);
        if (CGAL::is_certain(sign)) {
          ASSERT_EQ(static_cast<int>(sign.inf()), orientation(a, b, c));
        }
      }
    }
  }
}

}  // namespace
}  // namespace oplus
