// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(Wkt, polygon_has_an_outer_chain_and_holes) {
  const Region expected{{{rectangle(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  EXPECT_EQ(region_from("POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))\n").region,
            expected);
}

TEST(Wkt, needs_no_blanks_and_no_capitals) {
  EXPECT_EQ(region_from("\n\tpolygon((0 0,1e0 0,2/2\n1.0,0 1,0 0))").region,
            polygon(rectangle(0, 0, 1, 1)));
}

TEST(Wkt, multipolygon_has_components) {
  const Region expected{{{rectangle(0, 0, 1, 1), {}}, {rectangle(2, 0, 3, 1), {}}}};
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
  MinkowskiSum expected = canonical_sum(polygon(rectangle(0, 0, 9, 9)));
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

class RefusedWktRegion : public testing::TestWithParam<Refused> {};

TEST_P(RefusedWktRegion, says_why) {
  EXPECT_EQ(refusal([&] { region_from(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, RefusedWktRegion,
    testing::Values(
        Refused{
            "unknown_geometry", "TRIANGLE ((0 0, 1 0, 0 1, 0 0))",
            "file:1:1: 'TRIANGLE' where a geometry should be; expected POLYGON or MULTIPOLYGON"},
        Refused{"features_are_no_region", "\n POINT (0 0)",
                "file:2:2: 'POINT' where a geometry should be; expected POLYGON or MULTIPOLYGON"},
        Refused{"collection_is_no_region", "GEOMETRYCOLLECTION EMPTY",
                "file:1:1: 'GEOMETRYCOLLECTION' where a geometry should be; expected POLYGON or "
                "MULTIPOLYGON"},
        Refused{"three_dimensions", "POLYGON Z ((0 0 0, 1 0 0, 0 1 0, 0 0 0))",
                "file:1:9: 'Z' after POLYGON; expected coordinates in the plane, x and y only"},
        Refused{"third_coordinate", "POLYGON ((0 0 7, 1 0, 0 1, 0 0))",
                "file:1:15: '7' in outer chain of component 1; expected ',' or ')'"},
        Refused{"nothing_after_the_keyword", "POLYGON",
                "file:1:8: the end of the input in component 1; expected '(' or EMPTY"},
        Refused{"missing_parenthesis", "POLYGON (0 0, 1 0, 0 1, 0 0)",
                "file:1:10: '0' in outer chain of component 1; expected '(' or EMPTY"},
        Refused{"coordinate_missing", "POLYGON ((0 0, 1, 0 1, 0 0))",
                "file:1:17: ',' where y of vertex 2 of outer chain of component 1 should be; "
                "expected a number"},
        Refused{"vertex_missing", "POLYGON ((0 0, 1 0, , 0 0))",
                "file:1:21: ',' where x of vertex 3 of outer chain of component 1 should be; "
                "expected a number"},
        Refused{"chain_without_vertices", "POLYGON (())",
                "file:1:11: ')' where x of vertex 1 of outer chain of component 1 should be; "
                "expected a number"},
        Refused{
            "coordinate_is_not_a_number",
            "POLYGON ((0 0, 9 0, 0 9, 0 0),\n (1 1, 1 2, two 1, 1 1))",
            "file:2:13: x of vertex 3 of hole 1 of component 1: 'two' is not a number; expected "
            "an integer, a decimal or a fraction p/q"},
        Refused{"not_finite", "POLYGON ((0 0, inf 0, 0 9, 0 0))",
                "file:1:16: x of vertex 2 of outer chain of component 1: 'inf' is not finite; "
                "expected a finite number"},
        Refused{"zero_denominator", "POLYGON ((0 0, 1 1/0, 0 9, 0 0))",
                "file:1:18: y of vertex 2 of outer chain of component 1: '1/0' has the denominator "
                "0; expected a fraction p/q with q > 0"},
        Refused{"huge_exponent", "POLYGON ((0 0, 1 1e4097, 0 9, 0 0))",
                "file:1:18: y of vertex 2 of outer chain of component 1: '1e4097' has too large an "
                "exponent; expected an exponent from -4096 to 4096"},
        Refused{"ends_in_a_chain", "POLYGON ((0 0, 1 0, 0 1",
                "file:1:24: the end of the input in outer chain of component 1; expected ',' or "
                "')'"},
        Refused{"ends_in_a_polygon", "POLYGON ((0 0, 1 0, 0 1, 0 0)",
                "file:1:30: the end of the input in component 1; expected ',' or ')'"},
        Refused{"ends_in_a_multipolygon", "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0))\n",
                "file:1:37: the end of the input in MULTIPOLYGON; expected ',' or ')'"},
        Refused{"garbage_at_the_end", "POLYGON ((0 0, 1 0, 0 1, 0 0)) POLYGON",
                "file:1:32: 'POLYGON' after the geometry; expected the end of the input"},
        Refused{"parenthesis_too_many", "POLYGON ((0 0, 1 0, 0 1, 0 0)))",
                "file:1:31: ')' after the geometry; expected the end of the input"},
        Refused{"ring_is_not_closed", "POLYGON ((0 0, 1 0, 1 1,\n 0 1))",
                "file:2:2: outer chain of component 1 is not closed: it starts at (0, 0) and ends "
                "at (0, 1); expected the first vertex again at its end"},
        Refused{"hole_is_not_closed",
                "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((2 0, 9 0, 2 9, 2 0), (3 1, 3 2, 1/3 1)))",
                "file:1:73: hole 1 of component 2 is not closed: it starts at (3, 1) and ends at "
                "(1/3, 1); expected the first vertex again at its end"},
        Refused{"two_vertices", "POLYGON ((0 0, 1 0, 0 0))",
                "file:1:10: outer chain of component 1 has 2 vertices; expected at least 3"},
        Refused{"one_vertex", "POLYGON ((0 0))",
                "file:1:10: outer chain of component 1 has 1 vertex; expected at least 3"},
        Refused{"a_word_that_is_no_region", "hello",
                "file:1:1: 'hello' where a geometry should be; expected POLYGON or MULTIPOLYGON"}),
    test_name);

class RefusedWktSum : public testing::TestWithParam<Refused> {};

TEST_P(RefusedWktSum, says_why) {
  EXPECT_EQ(refusal([&] { sum_from(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, RefusedWktSum,
    testing::Values(
        Refused{"unknown_geometry", "CURVE (0 0, 1 1)",
                "file:1:1: 'CURVE' where a geometry should be; expected (MULTI)POLYGON, "
                "(MULTI)LINESTRING, (MULTI)POINT or GEOMETRYCOLLECTION"},
        Refused{"nested_collection", "GEOMETRYCOLLECTION (GEOMETRYCOLLECTION EMPTY)",
                "file:1:21: 'GEOMETRYCOLLECTION' where a geometry should be; expected "
                "(MULTI)POLYGON, (MULTI)LINESTRING or (MULTI)POINT"},
        Refused{"collection_not_closed", "GEOMETRYCOLLECTION (POINT (0 0)",
                "file:1:32: the end of the input in GEOMETRYCOLLECTION; expected ',' or ')'"},
        Refused{"point_without_parenthesis", "POINT 0 0",
                "file:1:7: '0' in POINT; expected '(' or EMPTY"},
        Refused{"point_of_three", "POINT (0 0 0)", "file:1:12: '0' in POINT; expected ')'"},
        Refused{"coordinate_of_a_point", "MULTIPOINT (0 0, 1 y)",
                "file:1:20: y of point 2: 'y' is not a number; expected an integer, a decimal or a "
                "fraction p/q"},
        Refused{"coordinate_of_a_line_string", "MULTILINESTRING ((0 0, 1 1), (0 0, 1))",
                "file:1:37: ')' where y of vertex 2 of line string 2 should be; expected a number"},
        Refused{"dimension_of_a_line_string", "LINESTRING M (0 0 1, 1 1 1)",
                "file:1:12: 'M' after LINESTRING; expected coordinates in the plane, x and y "
                "only"}),
    test_name);

}  // namespace
}  // namespace oplus
