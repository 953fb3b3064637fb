// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/fit.hpp"

#include <gtest/gtest.h>

namespace oplus {
namespace {

void expect_fit(std::size_t degree, const Points& points, const Fit& expected) {
  const std::optional<Fit> fit = fitted_curve(degree, points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->constant, expected.constant, 1e-9);
  EXPECT_NEAR(fit->linear, expected.linear, 1e-9);
  EXPECT_NEAR(fit->quadratic, expected.quadratic, degree == 1 ? 0 : 1e-9);
  EXPECT_NEAR(fit->r_squared, expected.r_squared, 1e-9);
}

TEST(Fit, finds_the_line_or_parabola_through_points_on_one) {
  expect_fit(1, {{0, 1, 2, 5}, {3, 5, 7, 13}}, {3, 2, 0, 1});
  expect_fit(2, {{1, 2, 3, 5, 8}, {6, 11, 18, 38, 83}}, {3, 2, 1, 1});
}

TEST(Fit, least_squares_for_points_on_no_curve) {
  // By the normal equations: residual sum of squares 0.7, total 4.75.
  expect_fit(1, {{0, 1, 2, 3}, {2, 3, 3, 5}}, {1.9, 0.9, 0, 1 - 0.7 / 4.75});
  // y = |x| on -2 to 2: 12/35 + 3/7 x², by the normal equations; 8/35 and 2.8.
  expect_fit(2, {{-2, -1, 0, 1, 2}, {2, 1, 0, 1, 2}}, {12.0 / 35, 0, 3.0 / 7, 1 - 8.0 / 35 / 2.8});
}

TEST(Fit, a_line_does_not_explain_a_parabola) {
  const Points parabola{{0, 1, 2, 3, 4}, {4, 1, 0, 1, 4}};
  EXPECT_NEAR(fitted_curve(1, parabola)->r_squared, 0, 1e-9);
  EXPECT_NEAR(fitted_curve(2, parabola)->r_squared, 1, 1e-9);
}

TEST(Fit, empty_for_too_few_different_x) {
  EXPECT_FALSE(fitted_curve(1, {}));
  EXPECT_FALSE(fitted_curve(1, {{1, 2, 2, 1}, {1, 2, 3, 4}}));
  EXPECT_EQ(fitted_curve(1, {{1, 2, 3}, {1, 1, 1}})->r_squared, 1);
  EXPECT_FALSE(fitted_curve(2, {{1, 2, 3, 3}, {1, 2, 3, 4}}));
  EXPECT_TRUE(fitted_curve(2, {{1, 2, 3, 4}, {1, 2, 3, 4}}));
}

TEST(Fit, formula_is_the_curve) {
  EXPECT_EQ(formula({1, -2, 0.5, 1}), "1.000000e+00 + (-2.000000e+00)*x + (5.000000e-01)*x**2");
}

}  // namespace
}  // namespace oplus
