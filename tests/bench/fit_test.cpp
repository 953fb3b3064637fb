// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/fit.hpp"

#include <gtest/gtest.h>

namespace oplus {
namespace {

TEST(Fit, finds_the_line_and_the_parabola_that_points_lie_on) {
  const auto line = fit_line({0, 1, 2, 5}, {3, 5, 7, 13});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->constant, 3, 1e-9);
  EXPECT_NEAR(line->linear, 2, 1e-9);
  EXPECT_EQ(line->quadratic, 0);
  EXPECT_NEAR(line->r_squared, 1, 1e-9);

  const auto parabola = fit_parabola({1, 2, 3, 5, 8}, {6, 11, 18, 38, 83});  // x² + 2x + 3
  ASSERT_TRUE(parabola);
  EXPECT_NEAR(parabola->constant, 3, 1e-9);
  EXPECT_NEAR(parabola->linear, 2, 1e-9);
  EXPECT_NEAR(parabola->quadratic, 1, 1e-9);
  EXPECT_NEAR(parabola->r_squared, 1, 1e-9);
}

TEST(Fit, least_squares_where_points_lie_on_none) {
  // By the normal equations: residual sum of squares 0.7, total 4.75.
  const auto line = fit_line({0, 1, 2, 3}, {2, 3, 3, 5});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->constant, 1.9, 1e-9);
  EXPECT_NEAR(line->linear, 0.9, 1e-9);
  EXPECT_NEAR(line->r_squared, 1 - 0.7 / 4.75, 1e-9);
  // y = |x| on -2 to 2: 12/35 + 3/7 x², by the normal equations.
  const auto parabola = fit_parabola({-2, -1, 0, 1, 2}, {2, 1, 0, 1, 2});
  ASSERT_TRUE(parabola);
  EXPECT_NEAR(parabola->constant, 12.0 / 35, 1e-9);
  EXPECT_NEAR(parabola->linear, 0, 1e-9);
  EXPECT_NEAR(parabola->quadratic, 3.0 / 7, 1e-9);
}

TEST(Fit, a_line_does_not_explain_a_parabola) {
  const std::vector<double> x = {0, 1, 2, 3, 4};
  const std::vector<double> y = {4, 1, 0, 1, 4};
  EXPECT_NEAR(fit_line(x, y)->r_squared, 0, 1e-9);
  EXPECT_NEAR(fit_parabola(x, y)->r_squared, 1, 1e-9);
}

TEST(Fit, nothing_from_too_few_different_x) {
  EXPECT_FALSE(fit_line({}, {}));
  EXPECT_FALSE(fit_line({1, 2, 2, 1}, {1, 2, 3, 4}));
  EXPECT_TRUE(fit_line({1, 2, 3}, {1, 1, 1}));
  EXPECT_FALSE(fit_parabola({1, 2, 3, 3}, {1, 2, 3, 4}));
  EXPECT_TRUE(fit_parabola({1, 2, 3, 4}, {1, 2, 3, 4}));
}

TEST(Fit, formula_is_the_curve) {
  EXPECT_EQ(formula({1, -2, 0.5, 1}), "1.000000e+00 + (-2.000000e+00)*x + (5.000000e-01)*x**2");
}

}  // namespace
}  // namespace oplus
