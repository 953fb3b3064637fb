// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/circle_point.hpp"

#include <gtest/gtest.h>

#include <array>

namespace oplus {
namespace {

TEST(CirclePoint, is_an_integer_point_next_to_the_circle) {
  Random random(1);
  const Rational radius = 1'000'000;
  for (int i = 0; i < 1000; ++i) {
    const Point p = circle_point(random, 1'000'000);
    EXPECT_EQ(p.x.get_den(), 1);
    EXPECT_EQ(p.y.get_den(), 1);
    // Each coordinate is off by at most 1/2, so the distance by less than 1.
    EXPECT_GT(dot(p, p), (radius - 1) * (radius - 1));
    EXPECT_LT(dot(p, p), (radius + 1) * (radius + 1));
  }
}

TEST(CirclePoint, has_each_direction_equally_often) {
  Random random(1);
  std::array<int, 8> in_octant{};
  for (int i = 0; i < 8000; ++i) {
    const Point p = circle_point(random, 1'000'000);
    const std::size_t octant =
        (sign(p.x) < 0 ? 1u : 0u) + (sign(p.y) < 0 ? 2u : 0u) + (abs(p.x) < abs(p.y) ? 4u : 0u);
    ++in_octant.at(octant);
  }
  for (const int count : in_octant) {
    EXPECT_GT(count, 880);
    EXPECT_LT(count, 1120);
  }
}

}  // namespace
}  // namespace oplus
