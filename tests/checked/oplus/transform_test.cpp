// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion frame =
    polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}});

TEST(Transformed, region_is_valid) {
  const AffineMap maps[] = {translation({0.5, "1/3"}),
                            scaling(-1, 2),
                            scaling("1/7", 1),
                            rotation(30),
                            rotation(90),
                            rotation_to({"-5/13", "12/13"}),
                            AffineMap{2, 1, 7, 3, {1, 1}}};
  for (const AffineMap& map : maps) {
    const ValidRegion there = transformed(frame, map);
    EXPECT_EQ(ValidRegion(there.region()), there);
    EXPECT_EQ(area(there), 12 * abs(map.determinant()));
    EXPECT_EQ(there.components()[0].outer[0], map({0, 0}));
  }
  EXPECT_EQ(transformed(frame, rotation(180)), -frame);
  EXPECT_EQ(transformed(frame, AffineMap()), frame);
}

TEST(Transformed, sum_is_the_sum_of_images_with_its_low_dimensional_parts) {
  const ValidRegion q = polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  const ValidSet open = minkowski_sum(frame, q, {.boundary = Boundary::open});
  ASSERT_EQ(open.dangling_edges().size(), 1U);
  for (const AffineMap& map : {scaling(1, -3), rotation(50), translation({1, 2})}) {
    const ValidSet there = transformed(open, map);
    EXPECT_EQ(there.boundary(), Boundary::open);
    EXPECT_EQ(there.dangling_edges().size(), 1U);
    AffineMap linear = map;
    linear.by = {};
    EXPECT_EQ(there, minkowski_sum(transformed(frame, linear), transformed(q, map),
                                   {.boundary = Boundary::open}));
  }
}

TEST(Transformed, unbounded_region_is_unbounded) {
  const ValidRegion outside = complement(frame);
  EXPECT_TRUE(is_unbounded(transformed(outside, scaling(-2, 2))));
  EXPECT_EQ(area(complement(transformed(outside, scaling(-2, 2)))), 48);
}

TEST(Transformed, refuses_maps_without_inverse) {
  EXPECT_THROW(transformed(frame, AffineMap{1, 1, 1, 1}), InvalidInput);
  EXPECT_THROW(transformed(ValidSet(), AffineMap{0, 0, 0, 1}), InvalidInput);
  EXPECT_THROW(rotation(1, 0), InvalidInput);
  EXPECT_THROW(rotation(1, -1), InvalidInput);
  EXPECT_THROW(scaling(1, 0), InvalidInput);
  EXPECT_THROW(scaling(0), InvalidInput);
}

TEST(Disc, is_a_valid_region_that_may_be_summed) {
  for (const DiscSide side : {DiscSide::inside, DiscSide::outside}) {
    const ValidRegion round = disc("5/2", side, 0.125);
    EXPECT_EQ(ValidRegion(round.region()), round);
    EXPECT_EQ(-round, transformed(round, rotation(180)));
    const double circle = 3.141592653589793 * 6.25;
    if (side == DiscSide::inside)
      EXPECT_LT(to_double(area(round)), circle);
    else
      EXPECT_GT(to_double(area(round)), circle);
    EXPECT_TRUE(contains(minkowski_sum(frame, round).region(), {-1, -1}));
  }
}

}  // namespace
}  // namespace oplus
