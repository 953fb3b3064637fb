// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion triangle = polygon({{0, 0}, {1, 0}, {0.5, "1/3"}});
const ValidRegion frame =
    polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});

ValidSet open_sum() {
  return minkowski_sum(frame, polygon({{0, 0}, {-2, 0}, {-2, -1}, {0, -1}}),
                       {.boundary = Boundary::open});
}

TEST(Text, of_a_region_is_exact_by_default) {
  EXPECT_EQ(to_wkt(triangle), "POLYGON ((0 0, 1 0, 0.5 1/3, 0 0))");
  EXPECT_EQ(to_geojson(triangle),
            R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0.5, "1/3"], [0, 0]]]})");
  EXPECT_EQ(to_wkt(ValidRegion()), "POLYGON EMPTY");
}

TEST(Text, is_read_again) {
  for (const ValidRegion& region : {triangle, frame, ValidRegion()}) {
    EXPECT_EQ(read_wkt(to_wkt(region)), region);
    EXPECT_EQ(read_geojson(to_geojson(region)), region);
  }
}

TEST(Text, of_a_sum_is_that_of_its_region) {
  const ValidSet sum = minkowski_sum(frame, triangle);
  EXPECT_EQ(to_wkt(sum), to_wkt(sum.region()));
  EXPECT_EQ(to_geojson(sum), to_geojson(sum.region()));
  EXPECT_EQ(to_wkt(ValidSet()), "POLYGON EMPTY");
}

TEST(Text, has_dangling_edges_and_isolated_vertices) {
  EXPECT_NE(to_wkt(open_sum()).find("GEOMETRYCOLLECTION (POLYGON (("), std::string::npos)
      << to_wkt(open_sum());
  EXPECT_NE(to_wkt(open_sum()).find("LINESTRING (1 1, 1 2)"), std::string::npos)
      << to_wkt(open_sum());
  EXPECT_NE(to_geojson(open_sum()).find(R"("type": "LineString", "coordinates": [[1, 1], [1, 2]])"),
            std::string::npos)
      << to_geojson(open_sum());
}

TEST(Text, is_rounded_if_asked) {
  EXPECT_EQ(to_wkt(triangle, 3), "POLYGON ((0 0, 1 0, 0.5 0.333, 0 0))");
  EXPECT_EQ(to_wkt(triangle, 0), "POLYGON EMPTY");
  EXPECT_EQ(to_geojson(triangle, 1),
            R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0.5, 0.3], [0, 0]]]})");
  const ValidSet sum = minkowski_sum(triangle, triangle);
  EXPECT_EQ(to_wkt(sum, 2), "POLYGON ((0 0, 2 0, 1 0.67, 0 0))");
  EXPECT_EQ(to_geojson(sum, 2),
            R"({"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [1, 0.67], [0, 0]]]})");
}

TEST(Text, of_what_was_rounded_is_valid) {
  const ValidSet sum = minkowski_sum(triangle, triangle);
  const Rounded nearest = rounded(sum, "0.3");
  EXPECT_EQ(to_wkt(nearest.sum), "POLYGON ((0 0, 2.1 0, 0.9 0.6, 0 0))");
  EXPECT_EQ(nearest.bound, Number("0.15").value());
  EXPECT_FALSE(nearest.is_exact);
  EXPECT_EQ(nearest.changes, TopologyChanges{});
  EXPECT_EQ(to_wkt(rounded(triangle, 1, Side::contained).sum), "POLYGON EMPTY");
  EXPECT_EQ(rounded(triangle, 1, Side::contained).changes.vanished_components, 1U);
  EXPECT_EQ(read_wkt(to_wkt(rounded(sum, 0.25, Side::contain).sum)),
            rounded(sum, 0.25, Side::contain).sum.region());
  EXPECT_TRUE(rounded(open_sum(), 1).is_exact);
  EXPECT_EQ(rounded(open_sum(), 1).sum, open_sum());
  for (const int step : {0, -1}) EXPECT_THROW(rounded(sum, step), InvalidInput);
}

TEST(Text, in_wkb_is_that_of_doubles) {
  const ValidRegion square = polygon({{0, 0}, {1, 0}, {1, 0.5}});
  EXPECT_EQ(to_wkb(square),
            "0103000000010000000400000000000000000000000000000000000000000000000000F03F"
            "0000000000000000000000000000F03F000000000000E03F00000000000000000000000000000000");
  EXPECT_TRUE(to_wkb(open_sum()).starts_with("0107000000"));
  EXPECT_THROW(to_wkb(triangle), InvalidInput);
}

TEST(Text, refuses_other_numbers_of_digits) {
  for (const int digits : {-1, 4097}) {
    EXPECT_THROW(to_wkt(triangle, digits), std::invalid_argument);
    EXPECT_THROW(to_geojson(triangle, digits), std::invalid_argument);
    EXPECT_THROW(to_wkt(ValidSet(), digits), std::invalid_argument);
    EXPECT_THROW(to_geojson(ValidSet(), digits), std::invalid_argument);
  }
  EXPECT_NO_THROW(to_wkt(triangle, 4096));
}

}  // namespace
}  // namespace oplus
