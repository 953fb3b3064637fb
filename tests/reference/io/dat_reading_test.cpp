// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(Dat, is_one_component_without_a_hole_count) {
  EXPECT_EQ(region_from("3 0 0 1/2 0 0 0.5\n").region,
            polygon({{0, 0}, {Rational(1, 2), 0}, {0, Rational(1, 2)}}));
}

TEST(Dat, may_have_a_hole_count_and_holes) {
  const Region expected{{{box(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  const ReadRegion read = region_from("4\n0 0 3 0 3 3 0 3\n1\n4\n1 1 1 2 2 2 2 1\n");
  EXPECT_EQ(read.region, expected);
  EXPECT_TRUE(read.notes.empty());
  EXPECT_EQ(region_from("4 0 0 1 0 1 1 0 1 0").region, polygon(box(0, 0, 1, 1)));
}

TEST(Dat, may_have_several_components) {
  const Region expected{{{box(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}},
                         {box(5, 0, 6, 1), {}},
                         {box(7, 0, 8, 1), {}}}};
  EXPECT_EQ(region_from("4 0 0 3 0 3 3 0 3 1 4 1 1 1 2 2 2 2 1\r\n"
                        "4 5 0 6 0 6 1 5 1 0\r\n"
                        "4 7 0 8 0 8 1 7 1 0\r\n")
                .region,
            expected);
}

TEST(Dat, zero_is_the_empty_region) {
  EXPECT_EQ(region_from("0\n").region, Region{});
  EXPECT_EQ(region_from(" 000 ").region, Region{});
}

}  // namespace
}  // namespace oplus
