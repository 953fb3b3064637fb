// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "properties/runner/temporary_folder.hpp"
#include "reference/chains/region_of.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(Reading, turns_chains_and_says_so) {
  const ReadRegion read = region_from(
      "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1), (3 3, 3 2, 2 3, 3 3),"
      " (3 1, 7/2 1, 3 2, 3 1)), ((9 0, 9 9, 10 0, 9 0)))");
  EXPECT_EQ(read.notes,
            std::vector<std::string>({"file: hole 3 of component 1 was counterclockwise; turned",
                                      "file: outer chain of component 2 was clockwise; turned"}));
  const Region expected{{{box(0, 0, 4, 4),
                          {{{1, 1}, {1, 2}, {2, 2}},
                           {{3, 3}, {3, 2}, {2, 3}},
                           {{3, 1}, {3, 2}, {Rational(7, 2), 1}}}},
                         {{{9, 0}, {10, 0}, {9, 9}}, {}}}};
  EXPECT_EQ(read.region, expected);
}

TEST(Reading, leaves_out_z_and_m_and_says_so_once) {
  const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  for (const auto& [text, count] :
       {std::pair<std::string, int>{"POLYGON Z ((0 0 5, 1 0 6, 0 1 7, 0 0 5))", 4},
        {"POLYGONM((0 0 5,1 0 6,0 1 7,0 0 5))", 4},
        {"polygon zm ((0 0 5 1, 1 0 6 2, 0 1 nan -1e-1, 0 0 5 1))", 4},
        {"SRID=1;POLYGON ((0 0 5, 1 0 NaN, 0 1 7/3, 0 0 5))", 4},
        {R"({"type": "Polygon", "coordinates": [[[0, 0, 5], [1, 0], [0, 1, 5, 6], [0, 0]]]})", 2},
        {"[[0, 0], [1, 0, 0], [0, 1]]", 1}}) {
    const std::string vertices = count == 1 ? " vertex" : " vertices";
    const std::vector<std::string> notes{"file: of " + std::to_string(count) + vertices +
                                         " with more than two coordinates, only x and y were read"};
    EXPECT_EQ(region_from(text).region, triangle) << text;
    EXPECT_EQ(region_from(text).notes, notes) << text;
    EXPECT_EQ(sum_from(text).notes, notes) << text;
  }
  EXPECT_EQ(sum_from("MULTIPOINT Z (1 2 3, (4 5 6))").sum.isolated_vertices,
            std::vector<Point>({{1, 2}, {4, 5}}));
}

TEST(Reading, of_an_svg_path_says_where_defects_are) {
  EXPECT_EQ(
      refusal([] { region_from("M 0 0 L 2 2\nH 0 L 2 0 Z"); }),
      "file:2:3: two edges of outer chain of component 1 cross at (1, 1): edge 1 from (0, 0) to "
      "(2, 2) and edge 3 from (0, 2) to (2, 0); expected a simple chain");
  // Both fill rules are common where a chain runs as the one around it.
  EXPECT_EQ(refusal([] { region_from("M0 0H9V9H0Z\nM1 1H2V2H1Z"); }),
            "file:2:2: outer chain of component 2 at (1, 1) is inside outer chain of component 1 "
            "and in none of its holes; expected components that at most touch");
}

TEST(Reading, allows_components_that_overlap_where_asked_to) {
  const std::string text =
      "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\n"
      "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))\n";
  EXPECT_EQ(refusal([&] { region_from(text); }).substr(0, 12), "file:2:26: o");
  EXPECT_EQ(read_region(text, "file", {}, Extent::bounded, Overlaps::allowed).region,
            Region({{{box(0, 0, 2, 2), {}}, {box(1, 1, 3, 3), {}}}}));
  EXPECT_EQ(
      refusal([&] {
        read_region(text + "POLYGON ((0 0, 1 1, 1 0,\n 0 1, 0 0))", "file", {}, Extent::bounded,
                    Overlaps::allowed);
      }),
      "file:3:21: two edges of outer chain of component 3 cross at (0.5, 0.5): edge 1 from (0, "
      "0) to (1, 1) and edge 3 from (1, 0) to (0, 1); expected a simple chain");
}

TEST(Reading, of_a_sum_turns_chains_and_says_so) {
  const ReadSum read = sum_from("4 0 0 0 1 1 1 1 0");
  EXPECT_EQ(read.notes,
            std::vector<std::string>({"file: outer chain of component 1 was clockwise; turned"}));
  EXPECT_EQ(read.sum, canonical_sum(polygon(box(0, 0, 1, 1))));
}

TEST(Reading, of_a_sum_makes_the_polygons_of_a_collection_one_region) {
  EXPECT_EQ(refusal([] {
              sum_from(
                  "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 0 9, 0 0)),\n"
                  " POLYGON ((1 1, 2 1, 1 2, 1 1)))");
            }),
            "file:2:12: outer chain of component 2 at (1, 1) is inside outer chain of component 1 "
            "and in none of its holes; expected components that at most touch");
}

TEST(Reading, where_says_file_line_and_column) {
  try {
    region_from("3 0 0\n 1 x 0 1");
    FAIL() << "accepted";
  } catch (const InvalidInput& refused) {
    EXPECT_EQ(refused.where().file, "file");
    EXPECT_EQ(refused.where().line, 2U);
    EXPECT_EQ(refused.where().column, 4U);
  }
}

TEST(Reading, reports_its_progress_and_where_the_check_starts) {
  const std::string megabytes(3 << 20, ' ');
  const std::string points = " 1 0," + megabytes + "0 1," + megabytes;
  for (const std::string& text :
       {"POLYGON ((0 0," + points + "0 0))", "3 0 0 " + megabytes + "1 0" + megabytes + " 0 1",
        R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0],)" + megabytes + "[0, 1]," +
            megabytes + "[0, 0]]]}"}) {
    std::vector<int> percents;
    const ReadRegion read =
        read_region(text, "file", [&](int percent) { percents.push_back(percent); });
    EXPECT_EQ(read.region, polygon({{0, 0}, {1, 0}, {0, 1}}));
    EXPECT_GE(percents.size(), 3U) << text.substr(0, 7);
    EXPECT_TRUE(std::is_sorted(percents.begin(), percents.end()));
    EXPECT_EQ(std::count(percents.begin(), percents.end(), 100), 1);
    EXPECT_EQ(percents.back(), 100);
    EXPECT_LT(percents.front(), 60);
  }
}

TEST(Reading, of_a_file_names_it) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "file.wkt";
  std::ofstream(path) << "POLYGON ((0 0, 0 1, 1 0, 0 0))";
  EXPECT_EQ(
      read_region_file(path).notes,
      std::vector<std::string>({path + ": outer chain of component 1 was clockwise; turned"}));
  std::ofstream(path) << "POLYGON (0 0)";
  EXPECT_EQ(refusal([&] { read_sum_file(path); }),
            path + ":1:10: '0' in outer chain of component 1; expected '(' or EMPTY");
}

TEST(Reading, of_a_file_that_is_not_there_says_so) {
  const std::string path = testing::TempDir() + "no_such_folder/file.dat";
  const std::string expected =
      path + ": cannot be opened (No such file or directory); expected a file that can be read";
  EXPECT_EQ(refusal([&] { read_region_file(path); }), expected);
  EXPECT_EQ(refusal([&] { read_sum_file(path); }), expected);
}

TEST(Reading, of_a_folder_says_so) {
  EXPECT_EQ(
      refusal([] { read_region_file("/"); }),
      "/: cannot be read (Is a directory); expected a region in .dat, WKT, WKB or GeoJSON, an array, or the data of an SVG path");
}

TEST(Reading, of_a_name_with_line_breaks_stays_in_one_line) {
  EXPECT_EQ(
      refusal([] { read_region_file("no\nfile"); }),
      "no\\x0afile: cannot be opened (No such file or directory); expected a file that can be "
      "read");
}

}  // namespace
}  // namespace oplus
