// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/invalid_region.hpp"

#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

class InvalidRegion : public testing::TestWithParam<Refused> {};

TEST_P(InvalidRegion, is_refused_as_a_region) {
  EXPECT_EQ(refusal([&] { region_from(GetParam().text); }), GetParam().message);
}

TEST_P(InvalidRegion, is_refused_as_a_sum) {
  EXPECT_EQ(refusal([&] { sum_from(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Vertices, InvalidRegion,
    testing::Values(
        Refused{
            "repeated_vertex", "6\n2 3\n1 1\n2 3\n4 4\n5 5\n6 7\n",
            "file:4:1: a vertex of outer chain of component 1 is repeated: vertices 1 and 3 are "
            "both (2, 3); expected each vertex of a chain once"},
        Refused{
            "repeated_vertex_of_a_turned_chain",
            "POLYGON ((0 0, 0 9, 3 3,\n 9 9, 9 0,\n 3 3, 0 0))",
            "file:3:2: a vertex of outer chain of component 1 is repeated: vertices 3 and 6 are "
            "both (3, 3); expected each vertex of a chain once"},
        Refused{"zero_length_edge", "4\n0 0\n1/3 0\n2/6 0\n0 1\n",
                "file:4:1: outer chain of component 1 has an edge of zero length: vertices 2 and 3 "
                "are both (1/3, 0); expected consecutive vertices to differ"},
        Refused{"zero_length_edge_at_the_end", "4\n0 0\n1 0\n0 1\n0 0\n",
                "file:5:1: outer chain of component 1 has an edge of zero length: vertices 1 and 4 "
                "are both (0, 0); expected consecutive vertices to differ"},
        Refused{"zero_length_edge_of_a_hole",
                "POLYGON ((0 0, 9 0, 0 9, 0 0),\n (1 1, 1 2, 2 1, 1 1),\n (3 3, 3 4, 4 3, 4 3, 3 "
                "3))",
                "file:3:18: hole 2 of component 1 has an edge of zero length: vertices 3 and 4 are "
                "both (4, 3); expected consecutive vertices to differ"}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Edges, InvalidRegion,
    testing::Values(
        Refused{
            "self_crossing", "4\n0 0\n2 2\n2 0\n0 2\n",
            "file:4:1: two edges of outer chain of component 1 cross at (1, 1): edge 1 from (0, "
            "0) to (2, 2) and edge 3 from (2, 0) to (0, 2); expected a simple chain"},
        Refused{
            "self_crossing_of_a_turned_chain", "4\n0 0\n0 4\n6 0\n6 1\n",
            "file:5:1: two edges of outer chain of component 1 cross at (4.8, 0.8): edge 2 from "
            "(0, 4) to (6, 0) and edge 4 from (6, 1) to (0, 0); expected a simple chain"},
        Refused{"self_crossing_of_a_hole",
                "{\"type\": \"MultiPolygon\", \"coordinates\": [\n"
                "[[[20,20],[30,20],[20,30],[20,20]]],\n"
                "[[[0,0],[9,0],[0,9],[0,0]],\n"
                " [[1,1],[3,3],[3,1],[1,3],[1,1]]]]}",
                "file:4:15: two edges of hole 1 of component 2 cross at (2, 2): edge 1 from (1, 1) "
                "to (3, 3) and edge 3 from (3, 1) to (1, 3); expected a simple chain"},
        Refused{"self_overlap", "4\n0 0\n4 0\n2 0\n2 2\n",
                "file:3:1: two edges of outer chain of component 1 overlap at (2, 0): edge 1 from "
                "(0, 0) to (4, 0) and edge 2 from (4, 0) to (2, 0); expected a simple chain"},
        Refused{"flat_chain", "3\n0 0\n1 0\n4 0\n",
                "file:4:1: two edges of outer chain of component 1 overlap at (0, 0): edge 1 from "
                "(0, 0) to (1, 0) and edge 3 from (4, 0) to (0, 0); expected a simple chain"},
        Refused{"self_touching", "5\n0 0\n4 0\n4 4\n2 0\n0 4\n",
                "file:5:1: outer chain of component 1 touches itself at (2, 0): edge 1 from (0, 0) "
                "to (4, 0) and edge 4 from (2, 0) to (0, 4); expected a simple chain"},
        Refused{
            "hole_crosses_outer_chain",
            "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0),\n(2 1, 3 3, 6 2, 2 1))",
            "file:2:12: outer chain of component 1 and hole 1 of component 1 cross at (4, 1.5): "
            "edge 2 from (4, 0) to (4, 4) and edge 3 from (6, 2) to (2, 1); expected chains "
            "that at most touch"},
        Refused{
            "components_cross", "4 0 0 4 0 4 4 0 4 0\n3 2 2 6 2 6 3 0\n",
            "file:2:3: outer chain of component 1 and outer chain of component 2 cross at (4, "
            "2): edge 2 from (4, 0) to (4, 4) and edge 1 from (2, 2) to (6, 2); expected chains "
            "that at most touch"},
        Refused{
            "components_cross_through_vertices", "3 4 4 -1 5 0 0 0\n4 0 0 4 0 4 4 0 4 0\n",
            "file:2:3: outer chain of component 1 and outer chain of component 2 cross at (0, "
            "0): edge 3 from (0, 0) to (4, 4) and edge 1 from (0, 0) to (4, 0); expected chains "
            "that at most touch"},
        Refused{"holes_overlap",
                "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0),\n(1 1, 1 3, 3 3, 3 1, 1 1),\n"
                "(3 2, 3 4, 5 4, 5 2, 3 2))",
                "file:3:2: hole 1 of component 1 and hole 2 of component 1 overlap at (3, 2): edge "
                "3 from (3, 3) to (3, 1) and edge 1 from (3, 2) to (3, 4); expected chains that at "
                "most touch in points"},
        Refused{"hole_overlaps_outer_chain",
                "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0),\n(0 1, 0 2, 1 2, 1 1, 0 1))",
                "file:2:2: outer chain of component 1 and hole 1 of component 1 overlap at (0, 1): "
                "edge 4 from (0, 4) to (0, 0) and edge 1 from (0, 1) to (0, 2); expected chains "
                "that at most touch in points"}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Nesting, InvalidRegion,
    testing::Values(
        Refused{"hole_outside", "4 0 0 4 0 4 4 0 4\n1\n3\n5 5\n5 6\n6 5\n",
                "file:4:1: hole 1 of component 1 at (5, 5) is not inside outer chain of component "
                "1; expected each hole inside its outer chain"},
        Refused{
            "hole_around_its_outer_chain",
            "POLYGON ((0 0, 1 0, 0 1, 0 0),\n(-9 -9, -9 9, 9 9, 9 -9, -9 -9))",
            "file:2:2: hole 1 of component 1 at (-9, -9) is not inside outer chain of component "
            "1; expected each hole inside its outer chain"},
        Refused{"hole_in_another_component",
                "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0), (6 1, 6 2, 7 1, 6 1)),\n"
                "((5 0, 15 0, 5 15, 5 0)))",
                "file:1:39: hole 1 of component 1 at (6, 1) is not inside outer chain of component "
                "1; expected each hole inside its outer chain"},
        Refused{
            "holes_nested",
            "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0),\n(1 1, 1 8, 8 8, 8 1, 1 1),\n"
            "(2 2, 2 3, 3 3, 2 2))",
            "file:3:2: hole 2 of component 1 at (2, 2) is inside hole 1 of component 1; expected "
            "holes beside each other"},
        Refused{"components_overlap", "4 0 0 9 0 9 9 0 9 0\n3\n1 1 2 1 1 2 0\n",
                "file:3:1: outer chain of component 2 at (1, 1) is inside outer chain of component "
                "1 and in none of its holes; expected components that at most touch"}),
    test_name);

TEST(ValidRegion, may_have_a_component_in_a_hole) {
  const ReadRegion read = region_from(
      "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 8, 8 8, 8 1, 1 1)),"
      " ((2 2, 3 2, 2 3, 2 2)))");
  EXPECT_EQ(read.region.components.size(), 2U);
}

TEST(ValidRegion, may_have_chains_that_touch) {
  const ReadRegion read = region_from(
      "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (0 0, 1 2, 2 1, 0 0)),"
      " ((4 4, 5 4, 5 5, 4 4)), ((4 2, 6 1, 6 3, 4 2)))");
  EXPECT_EQ(read.region.components.size(), 3U);
}

}  // namespace
}  // namespace oplus
