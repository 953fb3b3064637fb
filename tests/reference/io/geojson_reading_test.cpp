// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(GeoJson, polygon_has_an_outer_chain_and_holes) {
  const Region expected{{{box(0, 0, 3, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
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
  const std::string long_number(5000, '7');
  EXPECT_EQ(region_from("{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [" + long_number +
                        ", 0], [0, 1], [0, 0]]]}")
                .region.components.at(0)
                .outer.at(1)
                .x,
            Rational(long_number));
}

TEST(GeoJson, multipolygon_has_components) {
  const Region expected{{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, 1), {}}}};
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
  MinkowskiSum expected = canonical_sum(polygon(box(0, 0, 9, 9)));
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

std::string nested(std::size_t depth, const std::string& open) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += open;
  return text;
}

TEST(GeoJson, deep_nesting_is_refused) {
  EXPECT_EQ(refusal([] { region_from("{\"a\":" + nested(1000000, "[")); }),
            "file:1:69: JSON nested deeper than 64 levels; expected a geometry");
  EXPECT_EQ(refusal([] { region_from(nested(1000000, "{\"a\":")); }),
            "file:1:321: JSON nested deeper than 64 levels; expected a geometry");
}

}  // namespace
}  // namespace oplus
