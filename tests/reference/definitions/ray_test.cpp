// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/ray.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

/// Across the ray, one of its ends on it, behind it, along it, a point, beside it.
const std::vector<Segment> segments = {
    {{6, -1}, {6, 1}}, {{5, 0}, {5, 3}}, {{-1, -1}, {-1, 1}},          {{9, 0}, {8, 0}},
    {{3, 0}, {3, 0}},  {{1, 1}, {4, 1}}, {{2, 1}, {4, Rational(1, 9)}}};

TEST(Ray, meets_the_nearest_segment_first) {
  std::vector<Segment> left = segments;
  for (const int t : {3, 5, 6, 8}) {
    const std::optional<Rational> first = first_met({0, 0}, {1, 0}, left);
    ASSERT_TRUE(first);
    EXPECT_EQ(*first, t);
    EXPECT_EQ(*first_met({0, 0}, {2, 0}, left), Rational(t) / 2);
    std::erase_if(left, [&](const Segment& s) { return lies_on({t, 0}, s); });
  }
  EXPECT_FALSE(first_met({0, 0}, {1, 0}, left));
}

TEST(Ray, does_not_meet_what_it_starts_on) {
  EXPECT_EQ(first_met({6, 0}, {1, 0}, segments), Rational(2));
  EXPECT_EQ(first_met({8, 0}, {1, 0}, segments), Rational(1));  // the end of what runs along it
  EXPECT_FALSE(first_met({9, 0}, {1, 0}, segments));
}

TEST(Ray, has_a_point_before_it_meets_a_segment) {
  EXPECT_EQ(point_beside({4, 0}, {1, 0}, segments), (Point{Rational(9, 2), 0}));
  EXPECT_EQ(point_beside({0, 0}, {1, 0}, segments), (Point{1, 0}));
  EXPECT_EQ(point_beside({0, 0}, {1, 0}, {}), (Point{1, 0}));
  for (const Segment& s : segments) {
    for (const Vector& along : {Vector{1, 2}, {-3, 1}, {1, -1}}) {
      const Point x = point_beside(midpoint(s.source, s.target), along, segments);
      EXPECT_FALSE(lies_on_one(x, segments));
    }
  }
}

}  // namespace
}  // namespace oplus
