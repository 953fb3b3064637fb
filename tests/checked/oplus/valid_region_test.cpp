// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <list>
#include <utility>

#include "checked/oplus/oplus.hpp"
#include "tests/reference/io/refusal.hpp"

namespace oplus {
namespace {

const Chain square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Chain hole = {{1, 1}, {1, 3}, {3, 3}, {3, 1}};

Chain turned(const Chain& chain) {
  Chain result = {chain.rbegin(), chain.rend()};
  std::rotate(result.begin(), result.end() - 1, result.end());
  return result;
}

TEST(ValidRegion, is_empty_by_default) {
  EXPECT_TRUE(ValidRegion().components().empty());
  EXPECT_EQ(ValidRegion(), ValidRegion(Region{}));
  EXPECT_EQ(area(ValidRegion()), 0);
  EXPECT_FALSE(contains(ValidRegion(), {0, 0}));
}

TEST(ValidRegion, turns_chains_and_keeps_the_first_vertex) {
  const Region expected = {{{square, {hole}}}};
  EXPECT_EQ(ValidRegion(expected).region(), expected);
  EXPECT_EQ(ValidRegion(Region{{{turned(square), {turned(hole)}}}}).region(), expected);
  EXPECT_EQ(ValidRegion(expected).components(), expected.components);
}

TEST(ValidRegion, brings_coordinates_into_lowest_terms) {
  Region region = {{{square, {}}}};
  region.components[0].outer[2].x.get_num() = 8;
  region.components[0].outer[2].x.get_den() = 2;
  EXPECT_EQ(ValidRegion(region), ValidRegion(Region{{{square, {}}}}));
  region.components[0].outer[2].x.get_den() = 0;
  EXPECT_EQ(refusal([&] { ValidRegion{region}; }),
            "coordinate: the denominator is zero; expected a rational number");
}

TEST(ValidRegion, names_what_is_invalid) {
  const auto said = [](const Region& region) { return refusal([&] { ValidRegion{region}; }); };
  const std::vector<std::pair<Region, std::string>> cases = {
      {{{{{}, {}}}}, "vertices"},
      {{{{{{0, 0}, {1, 0}}, {}}}}, "vertices"},
      {{{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}}}, "edge 1 from (0, 0) to (2, 2)"},
      {{{{{{0, 0}, {2, 0}, {1, 0}}, {}}}}, "edge"},
      {{{{{{0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}}, {}}}}, "(2, 2)"},
      // The closing vertex is repeated.
      {{{{{{0, 0}, {2, 0}, {2, 2}, {0, 0}}, {}}}}, "(0, 0)"},
      {{{{square, {{{5, 5}, {5, 6}, {6, 6}}}}}}, "hole 1"},
      {{{{square, {{{1, 1}, {5, 1}, {1, 3}}}}}}, "hole 1"},
      {{{{square, {}}, {square, {}}}}, "component 2"},
  };
  for (const auto& [region, part] : cases) {
    const std::string message = said(region);
    EXPECT_EQ(message.find("region: "), 0U) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(ValidRegion, may_touch_itself_in_points) {
  EXPECT_NO_THROW(ValidRegion(Region{{{square, {}}, {{{4, 4}, {5, 4}, {5, 5}}, {}}}}));
  EXPECT_NO_THROW(ValidRegion(Region{{{square, {{{0, 1}, {2, 2}, {2, 1}}}}}}));
}

TEST(Polygon, is_a_valid_region) {
  EXPECT_EQ(polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}).region(), (Region{{{square, {}}}}));
  EXPECT_EQ(polygon({{0, 0}, {0, 4}, {4, 4}, {4, 0}}, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}}).region(),
            (Region{{{square, {hole}}}}));
  EXPECT_EQ(polygon({{0, 0}, {0.5, "1/3"}, {Rational(0), 1U}}).components()[0].outer,
            (Chain{{0, 0}, {Rational(1, 2), Rational(1, 3)}, {0, 1}}));
  EXPECT_EQ(refusal([] { polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}); }).find("region: "), 0U);
}

TEST(Polygon, takes_points_of_any_range) {
  struct Own {
    double x, y;
  };
  const ValidRegion expected = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  EXPECT_EQ(polygon(square), expected);
  EXPECT_EQ(polygon(std::vector<Own>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}), expected);
  EXPECT_EQ(polygon(std::list<std::pair<int, float>>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}), expected);
  EXPECT_EQ(polygon(std::array<std::array<long, 2>, 4>{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}),
            expected);
}

TEST(Reading, takes_the_union_of_what_overlaps_where_asked_to) {
  const std::string wkt =
      "POLYGON ((0 0, 3 0, 3 4, 0 4, 0 0))\nPOLYGON ((2 0, 4 0, 4 4, 2 4, 2 0))";
  const std::string json = "[[[[0,0],[3,0],[3,4],[0,4]]], [[[3,0],[4,0],[4,4],[3,4]]]]";
  EXPECT_THROW(read_wkt(wkt), InvalidInput);
  EXPECT_THROW(read_geojson(json), InvalidInput);
  EXPECT_EQ(read_wkt(wkt, Overlaps::allowed), polygon(square));
  EXPECT_EQ(read_geojson(json, Overlaps::allowed), polygon(square));
}

TEST(Reading, takes_its_own_format_only) {
  EXPECT_EQ(refusal([] { read_wkt("POLYGON((0 0,1 0,\n0 1)"); }).find("WKT:2:"), 0U);
  EXPECT_EQ(refusal([] { read_wkt("POLYGON((0 0,2 2,2 0,0 2,0 0))"); }).find("WKT:1"), 0U);
  EXPECT_EQ(refusal([] { read_geojson("POLYGON((0 0,1 0,0 1,0 0))"); }).find("GeoJSON:1:1"), 0U);
  EXPECT_EQ(refusal([] { read_wkt("3 0 0 1 0 0 1"); }).find("WKT:1:1"), 0U);
  EXPECT_EQ(refusal([] { read_wkt(""); }).find("WKT:1"), 0U);
}

TEST(Reading, tells_the_formats_of_files_apart) {
  const std::string path =
      (std::filesystem::temp_directory_path() / "oplus_valid_region_test").string();
  for (const std::string text :
       {"4 0 0 4 0 4 4 0 4", "POLYGON((0 0,4 0,4 4,0 4,0 0))",
        R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]})"}) {
    std::ofstream(path) << text;
    EXPECT_EQ(read_file(path), polygon(square)) << text;
  }
  std::ofstream(path) << "POLYGON((0 0,4 0)";
  EXPECT_EQ(refusal([&] { read_file(path); }).find(path + ":1:"), 0U);
  std::filesystem::remove(path);
  EXPECT_EQ(refusal([&] { read_file(path); }).find(path), 0U);
}

TEST(ValidRegion, is_reflected_by_a_minus) {
  const ValidRegion region(Region{{{{{1, 0}, {2, 0}, {1, Rational(1, 3)}}, {}}}});
  EXPECT_EQ((-region).components()[0].outer, (Chain{{-1, 0}, {-2, 0}, {-1, Rational(-1, 3)}}));
  EXPECT_EQ(-(-region), region);
}

TEST(ValidRegion, has_an_area_and_locations) {
  const ValidRegion region(Region{{{square, {hole}}}});
  EXPECT_EQ(area(region), 12);
  const std::vector<std::pair<Coordinates, Location>> cases = {{{0.5, 2}, Location::inside},
                                                               {{0, "1/3"}, Location::boundary},
                                                               {{3, 3}, Location::boundary},
                                                               {{2, 2}, Location::outside},
                                                               {{5, 0}, Location::outside}};
  for (const auto& [point, expected] : cases) {
    EXPECT_EQ(locate(point, region), expected) << point.point().x << ' ' << point.point().y;
    EXPECT_EQ(contains(region, point), expected != Location::outside);
  }
}

}  // namespace
}  // namespace oplus
