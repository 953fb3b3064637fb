// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(GeoJson, polygon_has_an_outer_chain_and_holes) {
  const Region expected{{{rectangle(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  EXPECT_EQ(region_from(R"({"type": "Polygon", "coordinates":
                        [[[0, 0], [3, 0], [3, 3], [0, 3], [0, 0]],
                         [[1, 1], [1, 2], [2, 2], [2, 1], [1, 1]]]})")
                .region,
            expected);
}

TEST(GeoJson, members_come_in_any_order_and_others_are_left_out) {
  EXPECT_EQ(region_from(R"({"bbox": [0, 0, 1, 1], "coordinates": [[[0,0],[1,0],[0,1],[0,0]]],
                        "crs": {"a \" [": [null, true]}, "type": "Polygon"})")
                .region,
            polygon({{0, 0}, {1, 0}, {0, 1}}));
}

TEST(GeoJson, numbers_are_exact) {
  const ReadRegion read = region_from(
      R"({"type": "Polygon", "coordinates": [[[0.1, -2.5e-3],
          [123456789012345678901234567890.1, 18446744073709551615],
          ["1/3", -9223372036854775809], [0.1, "-1/400"]]]})");
  EXPECT_EQ(
      read.region.components.at(0).outer,
      Chain({{Rational(1, 10), Rational(-1, 400)},
             {Rational(1, 3), Rational("-9223372036854775809")},
             {Rational("1234567890123456789012345678901/10"), Rational("18446744073709551615")}}));
  EXPECT_EQ(read.notes.size(), 1U);
}

TEST(GeoJson, numbers_beyond_a_double_are_exact) {
  const Region region = region_from(R"({"type": "Polygon",
      "coordinates": [[[0, 0], [1e4000, 0], [1e-4000, 1], [0, 0]]]})")
                            .region;
  EXPECT_EQ(region.components.at(0).outer.at(1).x * region.components.at(0).outer.at(2).x, 1);
}

TEST(GeoJson, multipolygon_has_components) {
  const Region expected{{{rectangle(0, 0, 1, 1), {}}, {rectangle(2, 0, 3, 1), {}}}};
  EXPECT_EQ(region_from(R"({"type": "MultiPolygon", "coordinates": [
                        [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]],
                        [[[2, 0], [3, 0], [3, 1], [2, 1], [2, 0]]]]})")
                .region,
            expected);
}

TEST(GeoJson, empty_is_the_empty_region) {
  EXPECT_EQ(region_from(R"({"type": "MultiPolygon", "coordinates": []})").region, Region{});
  EXPECT_EQ(region_from(R"({"type": "Polygon", "coordinates": []})").region, Region{});
  EXPECT_EQ(sum_from(R"({"type": "GeometryCollection", "geometries": []})").sum, MinkowskiSum{});
}

TEST(GeoJson, sum_may_have_line_strings_and_points) {
  MinkowskiSum expected = canonical_sum(polygon(rectangle(0, 0, 9, 9)));
  expected.dangling_edges = {
      {{1, 1}, {2, 2}}, {{2, 2}, {3, 1}}, {{5, 5}, {5, 6}}, {{6, 6}, {7, 6}}};
  expected.isolated_vertices = {{1, 8}, {3, 8}, {4, 8}};
  EXPECT_EQ(sum_from(R"({"type": "GeometryCollection", "geometries": [
      {"type": "LineString", "coordinates": [[3, 1], [2, 2], [1, 1]]},
      {"type": "Point", "coordinates": [4, 8]},
      {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]},
      {"type": "MultiPoint", "coordinates": [[3, 8], [1, 8]]},
      {"type": "MultiLineString", "coordinates": [[[5, 5], [5, 6]], [[7, 6], [6, 6]]]}]})")
                .sum,
            expected);
}

TEST(GeoJson, byte_order_mark_is_passed_over) {
  EXPECT_EQ(region_from("\xEF\xBB\xBF{\"type\": \"Polygon\", \"coordinates\": []}").region,
            Region{});
}

class RefusedGeoJsonRegion : public testing::TestWithParam<Refused> {};

TEST_P(RefusedGeoJsonRegion, says_why) {
  EXPECT_EQ(refusal([&] { region_from(GetParam().text); }), GetParam().message);
}

std::string polygon_of(const std::string& coordinates) {
  return "{\"type\": \"Polygon\",\n\"coordinates\":\n" + coordinates + "}";
}

std::string nested(std::size_t depth, const std::string& open) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += open;
  return text;
}

// No parameters, which every run of any test would make.
TEST(GeoJson, deep_nesting_is_refused) {
  EXPECT_EQ(refusal([] { region_from("{\"a\":" + nested(1000000, "[")); }),
            "file:1:69: JSON nested deeper than 64 levels; expected a geometry");
  EXPECT_EQ(refusal([] { region_from(nested(1000000, "{\"a\":")); }),
            "file:1:321: JSON nested deeper than 64 levels; expected a geometry");
}

INSTANTIATE_TEST_SUITE_P(
    Json, RefusedGeoJsonRegion,
    testing::Values(
        Refused{"ends_in_an_array", "{\"type\": [1, 2",
                "file:1:15: JSON syntax error while parsing array - unexpected end of input; "
                "expected ']'"},
        Refused{
            "ends_in_a_string", "{\"type\": \"Poly",
            "file:1:15: JSON syntax error while parsing value - invalid string: missing closing "
            "quote; expected JSON"},
        Refused{"not_a_literal", "{\"type\":\n Polygon}",
                "file:2:2: JSON syntax error while parsing value - invalid literal; expected JSON"},
        Refused{"comma_at_the_end", "{\"type\": [1, 2,]}",
                "file:1:16: JSON syntax error while parsing value - unexpected ']'; expected '[', "
                "'{', or a literal"},
        Refused{"colon_missing", "{\"type\" \"Polygon\"}",
                "file:1:9: JSON syntax error while parsing object separator - unexpected string "
                "literal; expected ':'"},
        Refused{"comma_missing", "{\"type\": [1 22]}",
                "file:1:13: JSON syntax error while parsing array - unexpected number literal; "
                "expected ']'"},
        Refused{"garbage_at_the_end", polygon_of("[]") + "\n]",
                "file:4:1: JSON syntax error while parsing value - unexpected ']'; expected end of "
                "input"},
        Refused{"key_twice", R"({"type": "Polygon", "type": "Point"})",
                "file:1:21: the member 'type' is said twice; expected it once"},
        Refused{
            "huge_exponent", "{\"a\": [0, -1e9999]}",
            "file:1:11: '-1e9999' has too large an exponent; expected an exponent from -4096 to "
            "4096"},
        Refused{"number_of_too_many_digits", "{\"a\": " + std::string(5000, '7') + "}",
                "file:1:7: '" + std::string(40, '7') +
                    "...' is too large for a JSON number; expected it as a string"}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Geometry, RefusedGeoJsonRegion,
    testing::Values(
        Refused{"array_is_no_geometry", "[1, 2]",
                "file:1:1: a geometry is an array; expected an object"},
        Refused{"no_type", "\n {\"coordinates\": []}",
                "file:2:2: an object without 'type'; expected a GeoJSON geometry"},
        Refused{"no_coordinates", "{\"type\": \"Polygon\"}",
                "file:1:1: an object without 'coordinates'; expected a GeoJSON geometry"},
        Refused{"type_is_a_number", "{\"type\": 3}",
                "file:1:10: the type of a geometry is a number; expected a string"},
        Refused{"unknown_type", "{\"type\": \"Feature\"}",
                "file:1:10: the type 'Feature'; expected Polygon or MultiPolygon"},
        Refused{"features_are_no_region", "{\"type\": \"Point\", \"coordinates\": [0, 0]}",
                "file:1:10: the type 'Point'; expected Polygon or MultiPolygon"},
        Refused{"coordinates_are_null", polygon_of("null"),
                "file:3:1: 'coordinates' of a Polygon is null; expected an array"},
        Refused{"coordinates_are_an_object", polygon_of("{}"),
                "file:3:1: 'coordinates' of a Polygon is an object; expected an array"},
        Refused{"chain_is_a_number", polygon_of("[1]"),
                "file:3:2: outer chain of component 1 is a number; expected an array"},
        Refused{"vertex_is_a_number", polygon_of("[[1, 2]]"),
                "file:3:3: vertex 1 of outer chain of component 1 is a number; expected an array "
                "[x, y]"},
        Refused{"vertex_of_three", polygon_of("[[[0, 0, 0]]]"),
                "file:3:3: vertex 1 of outer chain of component 1 has 3 coordinates; expected an "
                "array [x, y]"},
        Refused{"vertex_of_one", polygon_of("[[[0, 0], [1]]]"),
                "file:3:11: vertex 2 of outer chain of component 1 has 1 coordinate; expected an "
                "array [x, y]"},
        Refused{"coordinate_is_a_boolean", polygon_of("[[[0, 0], [1, true]]]"),
                "file:3:15: y of vertex 2 of outer chain of component 1 is a boolean; expected a "
                "number or a string \"p/q\""},
        Refused{"coordinate_is_a_word", polygon_of("[[[0, 0],\n[\"one\", 0]]]"),
                "file:4:2: x of vertex 2 of outer chain of component 1: 'one' is not a number; "
                "expected an integer, a decimal or a fraction p/q"},
        Refused{"zero_denominator", polygon_of("[[[0, \"1/0\"]]]"),
                "file:3:7: y of vertex 1 of outer chain of component 1: '1/0' has the denominator "
                "0; expected a fraction p/q with q > 0"},
        Refused{"not_finite", polygon_of("[[[0, \"NaN\"]]]"),
                "file:3:7: y of vertex 1 of outer chain of component 1: 'NaN' is not finite; "
                "expected a finite number"},
        Refused{"exponent_beyond_ours", polygon_of("[[[0, 1e-4097]]]"),
                "file:3:7: y of vertex 1 of outer chain of component 1: '1e-4097' has too large an "
                "exponent; expected an exponent from -4096 to 4096"},
        Refused{"ring_is_not_closed",
                polygon_of("[[[0,0],[9,0],[0,9],[0,0]],\n[[1,1],[1,2],[2,1]]]"),
                "file:4:14: hole 1 of component 1 is not closed: it starts at (1, 1) and ends at "
                "(2, 1); expected the first vertex again at its end"},
        Refused{"no_vertices", polygon_of("[[]]"),
                "file:3:2: outer chain of component 1 has 0 vertices; expected at least 3"},
        Refused{"two_vertices", polygon_of("[[[0,0],[1,0],[0,0]]]"),
                "file:3:2: outer chain of component 1 has 2 vertices; expected at least 3"},
        Refused{"component_without_chains", "{\"type\": \"MultiPolygon\", \"coordinates\": [[]]}",
                "file:1:42: component 1 has no chain; expected an outer chain"}),
    test_name);

class RefusedGeoJsonSum : public testing::TestWithParam<Refused> {};

TEST_P(RefusedGeoJsonSum, says_why) {
  EXPECT_EQ(refusal([&] { sum_from(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Geometry, RefusedGeoJsonSum,
    testing::Values(
        Refused{"unknown_type", "{\"type\": \"Curve\"}",
                "file:1:10: the type 'Curve'; expected (Multi)Polygon, (Multi)LineString, "
                "(Multi)Point or GeometryCollection"},
        Refused{"nested_collection",
                "{\"type\": \"GeometryCollection\", \"geometries\":\n"
                "[{\"type\": \"GeometryCollection\", \"geometries\": []}]}",
                "file:2:11: the type 'GeometryCollection'; expected (Multi)Polygon, "
                "(Multi)LineString or (Multi)Point"},
        Refused{"no_geometries", "{\"type\": \"GeometryCollection\"}",
                "file:1:1: an object without 'geometries'; expected a GeoJSON geometry"},
        Refused{"geometries_are_a_string",
                "{\"type\": \"GeometryCollection\", \"geometries\": \"\"}",
                "file:1:46: 'geometries' of a GeometryCollection is a string; expected an array"},
        Refused{"point_is_empty", "{\"type\": \"Point\", \"coordinates\": []}",
                "file:1:34: point 1 has 0 coordinates; expected an array [x, y]"},
        Refused{"line_string_of_one", "{\"type\": \"LineString\", \"coordinates\":\n [[0, 0]]}",
                "file:2:2: line string 1 has 1 vertex; expected at least 2"}),
    test_name);

}  // namespace
}  // namespace oplus
