// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(Wkt, polygon_has_an_outer_chain_and_holes) {
  const Region expected{{{box(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  EXPECT_EQ(region_from("POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))\n").region,
            expected);
}

TEST(Wkt, needs_no_blanks_and_no_capitals) {
  EXPECT_EQ(region_from("\n\tpolygon((0 0,1e0 0,2/2\n1.0,0 1,0 0))").region,
            polygon(box(0, 0, 1, 1)));
}

TEST(Wkt, multipolygon_has_components) {
  const Region expected{{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, 1), {}}}};
  EXPECT_EQ(
      region_from("MultiPolygon(((0 0,1 0,1 1,0 1,0 0)),EMPTY,((2 0,3 0,3 1,2 1,2 0)))").region,
      expected);
}

TEST(Wkt, empty_is_the_empty_region) {
  EXPECT_EQ(region_from("POLYGON EMPTY").region, Region{});
  EXPECT_EQ(region_from("multipolygon empty\n").region, Region{});
  EXPECT_EQ(sum_from("GEOMETRYCOLLECTION EMPTY").sum, MinkowskiSum{});
  EXPECT_EQ(sum_from("GEOMETRYCOLLECTION (POLYGON EMPTY, POINT EMPTY, LINESTRING EMPTY)").sum,
            MinkowskiSum{});
}

TEST(Wkt, sum_may_have_line_strings_and_points) {
  MinkowskiSum expected = canonical_sum(polygon(box(0, 0, 9, 9)));
  expected.dangling_edges = {
      {{1, 1}, {2, 2}}, {{2, 2}, {3, 1}}, {{5, 5}, {5, 6}}, {{6, 6}, {7, 6}}};
  expected.isolated_vertices = {{1, 8}, {2, 8}, {3, 8}, {4, 8}};
  EXPECT_EQ(sum_from("GEOMETRYCOLLECTION (LINESTRING (3 1, 2 2, 1 1), POINT (4 8),"
                     " POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)), MULTIPOINT (3 8, (2 8), EMPTY),"
                     " MULTILINESTRING ((5 5, 5 6), EMPTY, (7 6, 6 6)), MULTIPOINT ((1 8)))")
                .sum,
            expected);
}

TEST(Wkt, sum_may_have_no_region) {
  EXPECT_EQ(sum_from("POINT (1 2)").sum.isolated_vertices, std::vector<Point>({{1, 2}}));
  EXPECT_EQ(sum_from("MULTIPOINT (1 2, 0 0)").sum.isolated_vertices,
            std::vector<Point>({{0, 0}, {1, 2}}));
  EXPECT_EQ(sum_from("LINESTRING (1 2, 0 0)").sum.dangling_edges,
            std::vector<Segment>({{{0, 0}, {1, 2}}}));
}

}  // namespace
}  // namespace oplus
