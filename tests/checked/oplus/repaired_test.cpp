// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion square = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});

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

TEST(Repaired, fills_by_a_rule_or_refuses) {
  const Region tie = {{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}}};
  EXPECT_THROW(repaired(tie), InvalidInput);
  EXPECT_EQ(area(repaired(tie, FillRule::even_odd).region), 2);
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

}  // namespace
}  // namespace oplus
