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
