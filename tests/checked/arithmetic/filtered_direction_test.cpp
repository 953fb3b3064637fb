// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arithmetic/filtered_direction.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

const Rational huge("1" + std::string(400, '0'));

int sign_of(int value) { return (value > 0) - (value < 0); }

/// What the stage of intervals says, checked against the exact one where it says something.
std::optional<int> filtered(const Vector& u, const Vector& v) {
  const auto angles = filtered_compare_angle(FilteredDirection({u, Summand::P}),
                                             FilteredDirection({v, Summand::Q}));
  if (angles) {
    EXPECT_EQ(sign_of(*angles), sign_of(compare_angle(u, v)))
        << testing::PrintToString(u) << " and " << testing::PrintToString(v);
  }
  return angles;
}

void expect_compared_as_exact(const std::vector<Vector>& vectors) {
  for (const Vector& u : vectors) {
    for (const Vector& v : vectors) {
      for (const Summand of_u : {Summand::P, Summand::Q}) {
        for (const Summand of_v : {Summand::P, Summand::Q}) {
          const Direction a{u, of_u}, b{v, of_v};
          ASSERT_EQ(sign_of(compare(FilteredDirection(a), FilteredDirection(b))),
                    sign_of(compare(a, b)))
              << testing::PrintToString(u) << " and " << testing::PrintToString(v);
        }
      }
    }
  }
}

std::vector<Vector> small_integers() {
  std::vector<Vector> result;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      if (x != 0 || y != 0) result.push_back({x, y});
  return result;
}

TEST(FilteredDirection, intervals_must_answer_for_integers_below_two_to_the_26_and_ties_too) {
  for (const Vector& u : small_integers())
    for (const Vector& v : small_integers()) ASSERT_TRUE(filtered(u, v));
  const int most = (1 << 26) - 1;
  ASSERT_TRUE(filtered({most, most - 1}, {most - 1, most - 2}));
  ASSERT_EQ(filtered({most, most}, {1, 1}), 0);
  ASSERT_EQ(filtered({2 * (most / 6), 3 * (most / 6)}, {2, 3}), 0);
}

TEST(FilteredDirection, quadrants_and_axes_must_answer_whatever_the_size) {
  const Rational tiny = 1 / huge;
  ASSERT_TRUE(filtered({huge, 1}, {huge, 0}));
  ASSERT_TRUE(filtered({tiny, -huge}, {0, -tiny}));
  ASSERT_TRUE(filtered({-huge, tiny}, {-huge, -tiny}));
  ASSERT_EQ(filtered({-huge, 0}, {-tiny, 0}), 0);
  ASSERT_EQ(filtered({0, tiny}, {0, huge}), 0);
}

TEST(FilteredDirection, intervals_must_not_answer_where_doubles_cannot_tell) {
  ASSERT_FALSE(filtered({Rational(1, 3), 1}, {1, 3}));
  ASSERT_FALSE(filtered({huge, huge + 1}, {huge + 1, huge}));
  const Rational large = Rational(1) / Rational(3) * 1000003;
  ASSERT_FALSE(filtered({large, large + 1 / huge}, {1, 1}));
}

TEST(FilteredDirection, compares_as_exact_directions_with_their_ties) {
  expect_compared_as_exact(small_integers());
}

TEST(FilteredDirection, compares_as_exact_directions_beyond_doubles) {
  const Rational third(1, 3), tiny = 1 / huge;
  std::vector<Vector> vectors;
  for (const Rational& x : {third, Rational(1), Rational(3), huge, Rational(huge + 1), tiny})
    for (const Rational& y : {third, Rational(1), Rational(3), huge, Rational(huge + 1), tiny})
      for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) vectors.push_back({sx * x, sy * y});
  expect_compared_as_exact(vectors);
}

}  // namespace
}  // namespace oplus
