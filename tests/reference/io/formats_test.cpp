// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

template <typename Value>
struct Text {
  std::string name;
  std::string text;
  Value value;

  friend void PrintTo(const Text& row, std::ostream* out) { *out << row.text; }
};

const auto name_of = [](const auto& test) { return test.param.name; };

const Rational half(1, 2);
const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
const Region unit_square = polygon(box(0, 0, 1, 1));
const Component square_with_hole{box(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}};
const Region two_squares{{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, 1), {}}}};

class RegionText : public testing::TestWithParam<Text<Region>> {};

TEST_P(RegionText, stands_for_a_region) {
  const ReadRegion read = region_from(GetParam().text);
  EXPECT_EQ(read.region, GetParam().value);
  EXPECT_TRUE(read.notes.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Dat, RegionText,
    testing::ValuesIn(std::vector<Text<Region>>{
        {"triangle_after_blanks", "\n 3 0 0 1 0 0 1", triangle},
        {"without_hole_count", "3 0 0 1/2 0 0 0.5\n", polygon({{0, 0}, {half, 0}, {0, half}})},
        {"with_hole", "4\n0 0 3 0 3 3 0 3\n1\n4\n1 1 1 2 2 2 2 1\n", {{square_with_hole}}},
        {"no_hole", "4 0 0 1 0 1 1 0 1 0", unit_square},
        {"components",
         "4 0 0 3 0 3 3 0 3 1 4 1 1 1 2 2 2 2 1\r\n"
         "4 5 0 6 0 6 1 5 1 0\r\n"
         "4 7 0 8 0 8 1 7 1 0\r\n",
         {{square_with_hole, {box(5, 0, 6, 1), {}}, {box(7, 0, 8, 1), {}}}}},
        {"zero", "0\n", {}},
        {"zeros", " 000 ", {}}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Wkt, RegionText,
    testing::ValuesIn(std::vector<Text<Region>>{
        {"triangle_after_blanks", "\n Polygon ((0 0, 1 0, 0 1, 0 0))", triangle},
        {"with_hole",
         "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))\n",
         {{square_with_hole}}},
        {"no_blanks_no_capitals", "\n\tpolygon((0 0,1e0 0,2/2\n1.0,0 1,0 0))", unit_square},
        {"components", "MultiPolygon(((0 0,1 0,1 1,0 1,0 0)),EMPTY,((2 0,3 0,3 1,2 1,2 0)))",
         two_squares},
        {"component_in_a_hole",
         "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 8, 8 8, 8 1, 1 1)),"
         " ((2 2, 3 2, 2 3, 2 2)))",
         {{{box(0, 0, 9, 9), {{{1, 1}, {1, 8}, {8, 8}, {8, 1}}}}, {{{2, 2}, {3, 2}, {2, 3}}, {}}}}},
        {"chains_that_touch",
         "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (0 0, 1 2, 2 1, 0 0)),"
         " ((4 4, 5 4, 5 5, 4 4)), ((4 2, 6 1, 6 3, 4 2)))",
         {{{box(0, 0, 4, 4), {{{0, 0}, {1, 2}, {2, 1}}}},
           {{{4, 4}, {5, 4}, {5, 5}}, {}},
           {{{4, 2}, {6, 1}, {6, 3}}, {}}}}},
        {"several_a_line_each",
         "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n\nPOLYGON EMPTY\r\n"
         "MULTIPOLYGON (((2 0, 3 0, 3 1,\n 2 1, 2 0)))\n",
         two_squares},
        {"with_reference_system",
         "SRID=4326;POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
         " srid = 4326 ; POLYGON ((2 0, 3 0, 3 1, 2 1, 2 0))",
         two_squares},
        {"collection",
         "GeometryCollection (POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0)),"
         " MULTIPOLYGON (((2 0, 3 0, 3 1, 2 1, 2 0))))",
         two_squares},
        {"empty_collection", "GEOMETRYCOLLECTION EMPTY", {}},
        {"empty_with_z", "POLYGON Z EMPTY", {}},
        {"empty", "POLYGON EMPTY", {}},
        {"empty_multipolygon", "multipolygon empty\n", {}}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    GeoJson, RegionText,
    testing::ValuesIn(std::vector<Text<Region>>{
        {"triangle_after_blanks",
         "\n {\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,0],[0,1],[0,0]]]}", triangle},
        {"with_hole",
         R"({"type": "Polygon", "coordinates": [[[0, 0], [3, 0], [3, 3], [0, 3], [0, 0]],
             [[1, 1], [1, 2], [2, 2], [2, 1], [1, 1]]]})",
         {{square_with_hole}}},
        {"members_in_any_order_and_others",
         R"({"bbox": [0, 0, 1, 1], "coordinates": [[[0,0],[1,0],[0,1],[0,0]]],
             "crs": {"a \" [": [null, true]}, "type": "Polygon"})",
         triangle},
        {"components",
         R"({"type": "MultiPolygon", "coordinates": [[[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]],
             [[[2, 0], [3, 0], [3, 1], [2, 1], [2, 0]]]]})",
         two_squares},
        {"collection",
         R"({"type": "GeometryCollection", "geometries": [
             {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]},
             {"type": "MultiPolygon",
              "coordinates": [[[[2, 0], [3, 0], [3, 1], [2, 1], [2, 0]]]]}]})",
         two_squares},
        {"feature",
         R"({"type": "Feature", "properties": {"name": "unit"}, "geometry":
             {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}})",
         unit_square},
        {"feature_collection",
         R"({"type": "FeatureCollection", "features": [
             {"type": "Feature", "geometry": null},
             {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
              {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}]}},
             {"type": "Feature", "geometry": {"type": "Polygon",
              "coordinates": [[[2, 0], [3, 0], [3, 1], [2, 1], [2, 0]]]}}]})",
         two_squares},
        {"empty_feature_collection", R"({"type": "FeatureCollection", "features": []})", {}},
        {"empty", R"({"type": "Polygon", "coordinates": []})", {}},
        {"empty_multipolygon", R"({"type": "MultiPolygon", "coordinates": []})", {}},
        {"after_a_byte_order_mark",
         "\xEF\xBB\xBF{\"type\": \"Polygon\", \"coordinates\": []}",
         {}}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    PlainArrays, RegionText,
    testing::ValuesIn(std::vector<Text<Region>>{
        {"ring", "\n [[0, 0], [1, 0], [0, 1]]", triangle},
        {"closed_ring", "[[0,0],[1,0],[0,1],[0,0]]", triangle},
        {"fractions", R"([[0, 0], ["1/2", 0], [0, 0.5]])", polygon({{0, 0}, {half, 0}, {0, half}})},
        {"with_hole",
         "[[[0, 0], [3, 0], [3, 3], [0, 3]], [[1, 1], [1, 2], [2, 2], [2, 1], [1, 1]]]",
         {{square_with_hole}}},
        {"components", "[[[[0, 0], [1, 0], [1, 1], [0, 1]]], [[[2, 0], [3, 0], [3, 1], [2, 1]]]]",
         two_squares},
        {"empty", "[]", {}}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    SvgPath, RegionText,
    testing::ValuesIn(std::vector<Text<Region>>{
        {"triangle_after_blanks", "\n M 0 0 L 1 0 L 0 1 Z", triangle},
        {"closed_by_a_vertex", "M0,0 1,0 0,1 0,0", triangle},
        {"closed_twice", "M 0 0 L 1 0 L 0 1 L 0 0 z", triangle},
        {"horizontal_and_vertical", "M0 0H1V1H0Z", unit_square},
        {"relative", "m 1 1 h -1 v -1 h 1 z", polygon({{1, 1}, {0, 1}, {0, 0}, {1, 0}})},
        {"repeated", "M0 0H.5 1V.5 1e0L0 1Z",
         polygon({{0, 0}, {half, 0}, {1, 0}, {1, half}, {1, 1}, {0, 1}})},
        {"repeated_move_is_a_line", "m0 0 1 0 0 1-1 0z", unit_square},
        {"fractions", "M0 0L1/2 0,0+.5Z", polygon({{0, 0}, {half, 0}, {0, half}})},
        {"numbers_without_blanks", "M-.5.5.5-.5.5.5z",
         polygon({{-half, half}, {half, -half}, {half, half}})},
        {"hole_runs_the_other_way", "M0 0H3V3H0ZM1 1V2H2V1Z", {{square_with_hole}}},
        {"hole_before_its_outer_chain", "M1 1V2H2V1ZM0 0H3V3H0Z", {{square_with_hole}}},
        {"components", "M0 0h1v1h-1zm2 0h1v1h-1z", two_squares},
        {"after_z_from_the_start",
         "M1 1H0V0H1ZL2 2H1Z",
         {{{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}, {}}, {{{1, 1}, {2, 2}, {1, 2}}, {}}}}},
        {"component_in_a_hole",
         "M0 0H9V9H0ZM1 1V8H8V1ZM2 2H3L2 3Z",
         {{{box(0, 0, 9, 9), {{{1, 1}, {1, 8}, {8, 8}, {8, 1}}}},
           {{{2, 2}, {3, 2}, {2, 3}}, {}}}}}}),
    name_of);

class SumText : public testing::TestWithParam<Text<PlanarSet>> {};

TEST_P(SumText, stands_for_a_sum) { EXPECT_EQ(sum_from(GetParam().text).sum, GetParam().value); }

const std::vector<Segment> dangling{
    {{1, 1}, {2, 2}}, {{2, 2}, {3, 1}}, {{5, 5}, {5, 6}}, {{6, 6}, {7, 6}}};

INSTANTIATE_TEST_SUITE_P(
    All, SumText,
    testing::ValuesIn(std::vector<Text<PlanarSet>>{
        {"wkt_empty_collection", "GEOMETRYCOLLECTION EMPTY", {}},
        {"wkt_empty_geometries",
         "GEOMETRYCOLLECTION (POLYGON EMPTY, POINT EMPTY, LINESTRING EMPTY)",
         {}},
        {"geojson_empty_collection", R"({"type": "GeometryCollection", "geometries": []})", {}},
        {"wkt_features",
         "GEOMETRYCOLLECTION (LINESTRING (3 1, 2 2, 1 1), POINT (4 8),"
         " POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)), MULTIPOINT (3 8, (2 8), EMPTY),"
         " MULTILINESTRING ((5 5, 5 6), EMPTY, (7 6, 6 6)), MULTIPOINT ((1 8)))",
         {{box(0, 0, 9, 9)}, {}, dangling, {{1, 8}, {2, 8}, {3, 8}, {4, 8}}}},
        {"geojson_features",
         R"({"type": "GeometryCollection", "geometries": [
             {"type": "LineString", "coordinates": [[3, 1], [2, 2], [1, 1]]},
             {"type": "Point", "coordinates": [4, 8]},
             {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]},
             {"type": "MultiPoint", "coordinates": [[3, 8], [1, 8]]},
             {"type": "MultiLineString",
              "coordinates": [[[5, 5], [5, 6]], [[7, 6], [6, 6]]]}]})",
         {{box(0, 0, 9, 9)}, {}, dangling, {{1, 8}, {3, 8}, {4, 8}}}},
        {"wkt_point", "POINT (1 2)", {{}, {}, {}, {{1, 2}}}},
        {"wkt_points", "MULTIPOINT (1 2, 0 0)", {{}, {}, {}, {{0, 0}, {1, 2}}}},
        {"wkt_line_string", "LINESTRING (1 2, 0 0)", {{}, {}, {{{0, 0}, {1, 2}}}, {}}},
        {"wkt_collinear_edges",
         "LINESTRING (0 0, 1 1, 3 3, 3 0)",
         {{}, {}, {{{0, 0}, {3, 3}}, {{3, 0}, {3, 3}}}, {}}},
        {"wkt_polygons_of_a_collection",
         "GEOMETRYCOLLECTION (POLYGON ((2 0, 3 0, 3 1, 2 1, 2 0)),"
         " MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0))))",
         {{box(0, 0, 1, 1), box(2, 0, 3, 1)}, {}, {}, {}}},
        {"dat_not_canonical", "5 4 4 2 4 0 4 0 0 4 0", {{box(0, 0, 4, 4)}, {}, {}, {}}}}),
    name_of);

}  // namespace
}  // namespace oplus
