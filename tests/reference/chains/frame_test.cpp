// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/frame.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "reference/definitions/unbounded.hpp"

namespace oplus {
namespace {

const Chain hole = {{1, 1}, {1, 2}, {3, 1}};
const Region outside = {{Component{{}, {hole}}}};

TEST(Framed, has_an_outer_chain_around_all_vertices) {
  const Region region = framed(outside, 5);
  ASSERT_EQ(region.components.size(), 1U);
  EXPECT_EQ(region.components[0].outer, (Chain{{-4, -4}, {8, -4}, {8, 7}, {-4, 7}}));
  EXPECT_EQ(region.components[0].holes, (std::vector<Chain>{hole}));
}

TEST(Framed, the_plane_is_a_square_around_the_origin) {
  const Region region = framed(Region{{Component{}}}, 1);
  EXPECT_EQ(region.components.at(0).outer, (Chain{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}));
}

TEST(Framed, a_bounded_region_stays_as_it_is) {
  const Region region = polygon({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(framed(region, 5), region);
  EXPECT_EQ(framed(Region{}, 5), Region{});
}

TEST(Unframed, is_the_set_without_the_frame) {
  // A component in the hole stays, although it is smaller than the frame.
  const Region region = {
      {Component{{}, {{{0, 0}, {0, 9}, {9, 9}, {9, 0}}}}, Component{{{1, 1}, {2, 1}, {1, 2}}, {}}}};
  EXPECT_TRUE(is_unbounded(region));
  const PlanarSet set = unframed(canonical_sum(framed(region, 3)));
  EXPECT_TRUE(set.is_unbounded);
  EXPECT_EQ(set, canonical_sum(region));
  EXPECT_EQ(set.outer.size(), 1U);
  EXPECT_EQ(set.holes.size(), 1U);
}

TEST(RegionOf, an_unbounded_set_has_the_missing_outer_chain_last) {
  const Region region = {
      {Component{{{1, 1}, {2, 1}, {1, 2}}, {}}, Component{{}, {{{0, 0}, {0, 9}, {9, 9}, {9, 0}}}}}};
  EXPECT_EQ(region_of(canonical_sum(region)), region);
  PlanarSet plane;
  plane.is_unbounded = true;
  EXPECT_EQ(region_of(plane), Region{{Component{}}});
  EXPECT_EQ(canonical_sum(Region{{Component{}}}), plane);
}

}  // namespace
}  // namespace oplus
