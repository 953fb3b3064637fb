// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/exact_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reference/families/random.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers>
class ExactPointIn : public testing::Test {};
TYPED_TEST_SUITE(ExactPointIn, AllNumbers);

/// x(n / d) on the segment from one point to another.
template <typename Numbers>
ExactPoint<Numbers> at(const Segment& s, const mpz_class& n, const mpz_class& d) {
  return {integer_segment<Numbers>(s), fraction<Numbers>(n, d)};
}

template <typename Numbers>
void expect_equal(const ExactPoint<Numbers>& a, const ExactPoint<Numbers>& b) {
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a < b);
  EXPECT_FALSE(b < a);
}

template <typename Numbers>
void expect_different(const ExactPoint<Numbers>& a, const ExactPoint<Numbers>& b) {
  EXPECT_FALSE(a == b);
  EXPECT_NE(a < b, b < a);
}

TYPED_TEST(ExactPointIn, places_of_different_segments_are_equal_if_they_are) {
  const auto middle = at<TypeParam>({{0, 0}, {3, 5}}, 1, 2);  // (3/2, 5/2)
  expect_equal(middle, at<TypeParam>({{0, 0}, {3, 5}}, 17, 34));
  expect_equal(middle, at<TypeParam>({{3, 5}, {0, 0}}, 1, 2));
  expect_equal(middle, at<TypeParam>({{-3, 4}, {6, 1}}, 1, 2));
  expect_equal(middle, at<TypeParam>({{0, 4}, {9, -5}}, 3, 18));
  expect_different(middle, at<TypeParam>({{0, 0}, {3, 5}}, 16, 34));
  expect_different(middle, at<TypeParam>({{0, 0}, {3, 7}}, 1, 2));
  expect_different(middle, at<TypeParam>({{0, 0}, {5, 5}}, 1, 2));
  // Along axes, and at ends.
  expect_equal(at<TypeParam>({{7, 0}, {7, 9}}, 2, 6), at<TypeParam>({{0, 3}, {21, 3}}, 5, 15));
  expect_equal(at<TypeParam>({{7, 0}, {7, 9}}, 6, 6), at<TypeParam>({{7, 9}, {1, 2}}, 0, 1));
  expect_equal(at<TypeParam>({{-7, 9}, {0, 0}}, 0, 1), at<TypeParam>({{-7, 0}, {-7, 18}}, 3, 6));
}

TYPED_TEST(ExactPointIn, is_the_point_in_the_plane) {
  Random random(14);
  std::vector<std::pair<ExactPoint<TypeParam>, Point>> all;
  for (int k = 0; k < 300; ++k) {
    const auto number = [&] { return uniform(random, -4, 4); };
    const int ax = number(), ay = number(), bx = number(), by = number();
    const int d = uniform(random, 1, 8), n = uniform(random, 1, d), by_all = uniform(random, 1, 5);
    const Point a{ax, ay}, b{bx, by};
    const Rational t = Rational(n) / d;
    const Point expected = a + t * (b - a);
    all.emplace_back(at<TypeParam>({a, b}, n * by_all, d * by_all), expected);
    EXPECT_EQ(all.back().first.in_the_plane({}), expected);
    const auto expect_near = [](double near, const Rational& exact) {
      EXPECT_LE(abs(Rational(near) - exact), abs(exact) * power_of_two(-50));
    };
    expect_near(all.back().first.near_x({}), expected.x);
    expect_near(all.back().first.near_y({}), expected.y);
  }
  std::size_t equal = 0;
  for (const auto& [exact, point] : all) {
    for (const auto& [other_exact, other_point] : all) {
      EXPECT_EQ(exact == other_exact, point == other_point);
      EXPECT_EQ(exact < other_exact, point < other_point);
      EXPECT_EQ(exact.has_x_of(other_exact), point.x == other_point.x);
      if (point != other_point) continue;
      ++equal;
      EXPECT_EQ(exact.near_x({}), other_exact.near_x({})) << "named_ends() relies on it";
    }
  }
  EXPECT_GT(equal, all.size() + 100) << "not only each with itself";
}

TYPED_TEST(ExactPointIn, is_in_lowest_terms) {
  const Point p = at<TypeParam>({{1, 2}, {7, 11}}, 30, 90).in_the_plane({});
  EXPECT_EQ(p.x.get_num(), 3);
  EXPECT_EQ(p.x.get_den(), 1);
  EXPECT_EQ(p.y.get_num(), 5);
  EXPECT_EQ(p.y.get_den(), 1);
  const Point q = at<TypeParam>({{0, 0}, {10, -15}}, 4, 25).in_the_plane({});
  EXPECT_EQ(q.x.get_num(), 8);
  EXPECT_EQ(q.x.get_den(), 5);
  EXPECT_EQ(q.y.get_num(), -12);
  EXPECT_EQ(q.y.get_den(), 5);
}

TYPED_TEST(ExactPointIn, is_exact_at_the_limits) {
  constexpr unsigned bits = is_small<TypeParam> ? 29 : 124;
  const mpz_class m = (mpz_class(1) << bits) - 1, d = (mpz_class(1) << (2 * bits + 3)) - 1;
  // A segment of the convolution: an edge of a summand at a vertex of the other.
  for (const int sx : {1, -1}) {
    for (const int sy : {1, -1}) {
      const Point a{2 * sx * m, 2 * sy * m}, b{0, 0};
      for (const mpz_class& n : {mpz_class(1), mpz_class(d - 1), mpz_class(d / 3)}) {
        const Rational t = Rational(n) / d;
        const Point expected = a + t * (b - a);
        EXPECT_EQ(at<TypeParam>({a, b}, n, d).in_the_plane({}), expected);
        expect_equal(at<TypeParam>({a, b}, n, d), at<TypeParam>({b, a}, d - n, d));
        expect_different(at<TypeParam>({a, b}, n, d), at<TypeParam>({a, b}, n + 1, d));
        for (const mpz_class& other : {mpz_class(n - 1), mpz_class(n + 1)})
          EXPECT_EQ(at<TypeParam>({a, b}, n, d) < at<TypeParam>({a, b}, other, d - 2),
                    expected < a + (Rational(other) / mpz_class(d - 2)) * (b - a));
      }
    }
  }
}

TYPED_TEST(ExactPointIn, is_put_back_where_the_summands_were) {
  Scaling scaling;
  scaling.denominator = 6;
  scaling.is_moved = true;
  scaling.of_p = {100, -5};
  scaling.of_q = {1, 1};
  const Point expected{Rational(205, 12), Rational(-1, 4)};
  const auto exact = at<TypeParam>({{0, 0}, {3, 5}}, 1, 2);
  EXPECT_EQ(exact.in_the_plane(scaling), expected);
  Point at;
  exact.put_into(at, scaling);
  EXPECT_EQ(at, expected);
}

TEST(ExactPoint, near_coordinates_are_shifted) {
  const mpz_class m = mpz_class(1) << 2000;
  Scaling scaling;
  scaling.bits = 2001;
  scaling.shift = 1941;
  const ExactPoint<AnyNumbers> exact(integer_segment<AnyNumbers>({{0, 0}, {m, -m}}), {1, 4});
  EXPECT_EQ(exact.near_x(scaling), 0x1p57);
  EXPECT_EQ(exact.near_y(scaling), -0x1p57);
}

TEST(ExactPointOfSmallNumbers, at_zero_over_anything_is_the_source) {
  const auto segment = integer_segment<SmallNumbers>({{1, 2}, {4, 6}});
  EXPECT_TRUE(ExactPoint<SmallNumbers>(segment, {0, 1}) ==
              ExactPoint<SmallNumbers>(segment, {0, 5}));
}

TEST(ExactPointOfSmallNumbers, is_put_into_a_point_that_was_another_one) {
  Point at{Rational(1, 3), Rational(2, 7)};
  ExactPoint<SmallNumbers>(integer_segment<SmallNumbers>({{1, 2}, {4, 6}}), {0, 1})
      .put_into(at, {});
  EXPECT_EQ(at, (Point{1, 2}));
}

}  // namespace
}  // namespace oplus::slide
