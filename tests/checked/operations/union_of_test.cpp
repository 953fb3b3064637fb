// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/union_of.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "reference/io/reading.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

PlanarSet value(const std::string& text) { return read_sum(text, "text").sum; }

TEST(UnionOf, joins_components_that_overlap_touch_or_share_walls) {
  EXPECT_EQ(union_of(together({polygon(box(0, 0, 2, 2)), polygon(box(1, 1, 3, 3))})),
            value("POLYGON((0 0,2 0,2 1,3 1,3 3,1 3,1 2,0 2,0 0))"));
  EXPECT_EQ(union_of(together({polygon(box(0, 0, 2, 2)), polygon(box(2, 0, 3, 2))})),
            value("POLYGON((0 0,3 0,3 2,0 2,0 0))"));
  EXPECT_EQ(union_of(together({polygon(box(0, 0, 2, 2)), polygon(box(0, 0, 2, 2))})),
            value("POLYGON((0 0,2 0,2 2,0 2,0 0))"));
  EXPECT_EQ(union_of(together({polygon(box(0, 0, 1, 1)), polygon(box(1, 1, 2, 2))})),
            value("MULTIPOLYGON(((0 0,1 0,1 1,0 1,0 0)),((1 1,2 1,2 2,1 2,1 1)))"));
}

TEST(UnionOf, fills_a_hole_only_where_another_component_is) {
  EXPECT_EQ(
      union_of(together({holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)}), polygon(box(2, 1, 3, 3))})),
      value("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,2 3,2 1,1 1))"));
  EXPECT_EQ(
      union_of(together({holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)}), polygon(box(1, 1, 3, 3))})),
      value("POLYGON((0 0,4 0,4 4,0 4,0 0))"));
  // Four bars around a hole that none of them has.
  EXPECT_EQ(union_of(together({polygon(box(0, 0, 4, 1)), polygon(box(0, 3, 4, 4)),
                               polygon(box(0, 0, 1, 4)), polygon(box(3, 0, 4, 4))})),
            value("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))"));
}

TEST(UnionOf, of_each_valid_region_alone_is_that_region) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    EXPECT_EQ(union_of(shape.region), canonical_sum(shape.region));
    EXPECT_EQ(union_of(together({shape.region, shape.region})), canonical_sum(shape.region));
  }
}

TEST(UnionOf, keeps_of_segments_what_is_outside_and_joins_those_in_line) {
  EXPECT_EQ(union_of(polygon(box(0, 0, 2, 2)),
                     {{{-1, 1}, {3, 1}}, {{3, 1}, {5, 1}}, {{0, 0}, {2, 0}}, {{1, 1}, {1, 1}}}),
            value("GEOMETRYCOLLECTION(POLYGON((0 0,2 0,2 2,0 2,0 0)),LINESTRING(-1 1,0 1),"
                  "LINESTRING(2 1,5 1))"));
  EXPECT_EQ(union_of({}, {{{2, 2}, {0, 0}}, {{1, 1}, {3, 3}}, {{0, 2}, {2, 0}}}),
            value("MULTILINESTRING((0 0,3 3),(0 2,2 0))"));
  // Along a boundary and on.
  EXPECT_EQ(union_of(polygon(box(0, 0, 2, 2)), {{{-1, 2}, {4, 2}}}),
            value("GEOMETRYCOLLECTION(POLYGON((0 0,2 0,2 2,0 2,0 0)),LINESTRING(-1 2,0 2),"
                  "LINESTRING(2 2,4 2))"));
}

TEST(UnionOf, keeps_points_that_are_on_nothing_once) {
  EXPECT_EQ(union_of(polygon(box(0, 0, 2, 2)), {{{3, 0}, {3, 4}}, {{5, 5}, {5, 5}}},
                     {{1, 1}, {2, 1}, {0, 0}, {3, 2}, {4, 4}, {4, 4}, {5, 5}}),
            value("GEOMETRYCOLLECTION(POLYGON((0 0,2 0,2 2,0 2,0 0)),LINESTRING(3 0,3 4),"
                  "MULTIPOINT(4 4,5 5))"));
  EXPECT_EQ(
      union_of(holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)}), {}, {{2, 2}}).isolated_vertices.size(),
      1U);
}

TEST(UnionOf, of_nothing_is_empty) { EXPECT_EQ(union_of({}), PlanarSet{}); }

TEST(UnionOf, takes_the_plane_without_holes) {
  Region outside;
  outside.components.push_back({{}, {backwards(box(0, 0, 4, 4))}});
  const PlanarSet all = union_of(together({outside, polygon(box(1, 1, 2, 2))}), {{{-1, 3}, {3, 3}}},
                                 {{9, 9}, {3, 1}});
  EXPECT_TRUE(all.is_unbounded);
  EXPECT_EQ(all.outer, std::vector<Chain>{box(1, 1, 2, 2)});
  EXPECT_EQ(all.holes.size(), 1U);
  EXPECT_EQ(all.dangling_edges, (std::vector<Segment>{{{0, 3}, {3, 3}}}));
  EXPECT_EQ(all.isolated_vertices, (std::vector<Point>{{3, 1}}));
}

}  // namespace
}  // namespace oplus
