// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

template <typename Call>
std::string message_of(const Call& call) {
  try {
    call();
    return "accepted";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

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
  const std::string refusal =
      "transformation: the determinant is zero; expected a map that has an inverse";
  EXPECT_EQ(message_of([] { transformed(frame, AffineMap{1, 1, 1, 1}); }), refusal);
  EXPECT_EQ(message_of([] { transformed(ValidSet(), AffineMap{0, 0, 0, 1}); }), refusal);
  EXPECT_EQ(message_of([] { scaling(0, 1); }),
            "scaling: a factor is zero; expected two that are not");
  EXPECT_EQ(message_of([] { rotation(1, 0); }),
            "rotation: the error is zero; expected a positive one");
  EXPECT_EQ(message_of([] {
              rotation_to({0.6, 0.8});
            }),
            "rotation: the squares of cosine and sine don't add up to 1; expected a point of the "
            "unit circle, such as 3/5,4/5");
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

TEST(Disc, refuses_what_is_not_positive) {
  EXPECT_EQ(message_of([] { disc(0, DiscSide::inside, 1); }),
            "disc: the radius is zero; expected a positive one");
  EXPECT_EQ(message_of([] { disc(1, DiscSide::outside, -1); }),
            "disc: the error is negative; expected a positive one");
  EXPECT_EQ(message_of([] { disc(1, DiscSide::outside, 1e-300); }),
            "disc: this error needs more than 1000000 vertices; expected a larger one");
}

}  // namespace
}  // namespace oplus
