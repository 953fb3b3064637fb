// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion square = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});

TEST(ReadText, takes_every_form) {
  for (const std::string text :
       {"4 0 0 4 0 4 4 0 4", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
        "SRID=4326;GEOMETRYCOLLECTION (POLYGON Z ((0 0 1, 4 0 1, 4 4 1, 0 4 1, 0 0 1)))",
        R"({"type": "Feature", "geometry": {"type": "Polygon",
            "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}})",
        "[[0, 0], [4, 0], [4, 4], [0, 4]]", "M0 0h4v4h-4z"})
    EXPECT_EQ(read_text(text), square) << text;
  EXPECT_THROW(read_text(""), InvalidInput);
  EXPECT_THROW(read_text("M0 0C1 1 2 2 3 3z"), InvalidInput);
  // These take their own format only.
  EXPECT_THROW(read_wkt("M0 0h4v4h-4z"), InvalidInput);
  EXPECT_EQ(read_geojson("[[0, 0], [4, 0], [4, 4], [0, 4]]"), square);
}

TEST(ReadText, takes_the_union_of_what_overlaps_where_asked_to) {
  const std::string wkt =
      "POLYGON ((0 0, 3 0, 3 4, 0 4, 0 0))\nPOLYGON ((2 0, 4 0, 4 4, 2 4, 2 0))";
  const std::string json = "[[[[0,0],[3,0],[3,4],[0,4]]], [[[3,0],[4,0],[4,4],[3,4]]]]";
  EXPECT_THROW(read_wkt(wkt), InvalidInput);
  EXPECT_THROW(read_geojson(json), InvalidInput);
  EXPECT_EQ(read_wkt(wkt, Overlaps::allowed), square);
  EXPECT_EQ(read_text(wkt, Overlaps::allowed), square);
  EXPECT_EQ(read_geojson(json, Overlaps::allowed), square);
  EXPECT_THROW(read_wkt("POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))", Overlaps::allowed), InvalidInput);
}

TEST(Repaired, says_what_was_done) {
  Region region = square.region();
  region.components[0].outer.insert(region.components[0].outer.begin(), {0, 0});
  const Repaired result = repaired(region);
  EXPECT_EQ(result.region, square);
  ASSERT_EQ(result.mends.size(), 1U);
  EXPECT_EQ(result.mends[0].kind, MendKind::repeated_vertex);
  EXPECT_EQ(result.mends[0].where.file, "region");
  EXPECT_EQ(result.mends[0].what,
            "vertex 2 of outer chain of component 1 is equal to vertex 1, (0, 0); left out");
  EXPECT_TRUE(repaired(square.region()).mends.empty());
  EXPECT_TRUE(repaired(Region{}).mends.empty());
}

TEST(Repaired, takes_texts_and_files) {
  const Repaired of_text = repaired_text("POLYGON ((0 0, 4 0, 4 4, 0 4))");
  EXPECT_EQ(of_text.region, square);
  ASSERT_EQ(of_text.mends.size(), 1U);
  EXPECT_EQ(of_text.mends[0].kind, MendKind::closed_ring);
  EXPECT_EQ(of_text.mends[0].where.column, 26U);
  const std::string path = testing::TempDir() + "repaired_test.wkt";
  std::ofstream(path) << "POLYGON ((0 0, 4 0, 4 4, 0 4))";
  EXPECT_EQ(repaired_file(path).region, square);
  std::filesystem::remove(path);
  EXPECT_THROW(repaired_file(path), InvalidInput);
  EXPECT_THROW(repaired_text("POLYGON ((0 0"), InvalidInput);
}

TEST(Repaired, fills_by_a_rule_or_refuses) {
  const Region tie = {{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}}};
  EXPECT_THROW(repaired(tie), InvalidInput);
  for (const FillRule rule : {FillRule::even_odd, FillRule::nonzero})
    EXPECT_EQ(area(repaired(tie, rule).region), 2);
}

}  // namespace
}  // namespace oplus
