// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/reading.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(Reading, tells_the_formats_apart) {
  const Region expected = polygon({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(region_from("\n 3 0 0 1 0 0 1").region, expected);
  EXPECT_EQ(region_from("\n Polygon ((0 0, 1 0, 0 1, 0 0))").region, expected);
  EXPECT_EQ(region_from("\n {\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,0],[0,1],[0,0]]]}")
                .region,
            expected);
}

TEST(Reading, turns_chains_and_says_so) {
  const ReadRegion read = region_from(
      "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1), (3 3, 3 2, 2 3, 3 3),"
      " (3 1, 7/2 1, 3 2, 3 1)), ((9 0, 9 9, 10 0, 9 0)))");
  EXPECT_EQ(read.notes,
            std::vector<std::string>({"file: hole 3 of component 1 was counterclockwise; turned",
                                      "file: outer chain of component 2 was clockwise; turned"}));
  const Region expected{{{rectangle(0, 0, 4, 4),
                          {{{1, 1}, {1, 2}, {2, 2}},
                           {{3, 3}, {3, 2}, {2, 3}},
                           {{3, 1}, {3, 2}, {Rational(7, 2), 1}}}},
                         {{{9, 0}, {10, 0}, {9, 9}}, {}}}};
  EXPECT_EQ(read.region, expected);
}

TEST(Reading, of_a_sum_turns_chains_and_says_so) {
  const ReadSum read = sum_from("4 0 0 0 1 1 1 1 0");
  EXPECT_EQ(read.notes,
            std::vector<std::string>({"file: outer chain of component 1 was clockwise; turned"}));
  EXPECT_EQ(read.sum, canonical_sum(polygon(rectangle(0, 0, 1, 1))));
}

TEST(Reading, of_a_sum_is_canonical) {
  EXPECT_EQ(sum_from("5 4 4 2 4 0 4 0 0 4 0").sum, canonical_sum(polygon(rectangle(0, 0, 4, 4))));
}

TEST(Reading, of_a_sum_makes_the_polygons_of_a_collection_one_region) {
  EXPECT_EQ(sum_from("GEOMETRYCOLLECTION (POLYGON ((2 0, 3 0, 3 1, 2 1, 2 0)),"
                     " MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0))))")
                .sum,
            canonical_sum(Region{{{rectangle(0, 0, 1, 1), {}}, {rectangle(2, 0, 3, 1), {}}}}));
  EXPECT_EQ(refusal([] {
              sum_from(
                  "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 0 9, 0 0)),\n"
                  " POLYGON ((1 1, 2 1, 1 2, 1 1)))");
            }),
            "file:2:12: outer chain of component 2 at (1, 1) is inside outer chain of component 1 "
            "and in none of its holes; expected components that at most touch");
}

TEST(Reading, of_a_sum_joins_collinear_dangling_edges) {
  EXPECT_EQ(sum_from("LINESTRING (0 0, 1 1, 3 3, 3 0)").sum.dangling_edges,
            std::vector<Segment>({{{0, 0}, {3, 3}}, {{3, 0}, {3, 3}}}));
}

class RefusedFeatures : public testing::TestWithParam<Refused> {};

TEST_P(RefusedFeatures, says_why) {
  EXPECT_EQ(refusal([&] { sum_from(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Sum, RefusedFeatures,
    testing::Values(
        Refused{"line_string_of_one_vertex", "MULTILINESTRING ((0 0, 1 1),\n (5 5))",
                "file:2:2: line string 2 has 1 vertex; expected at least 2"},
        Refused{"zero_length_dangling_edge", "LINESTRING (0 0, 1/2 1,\n0.5 1)",
                "file:2:1: line string 1 has an edge of zero length: vertices 2 and 3 are both "
                "(0.5, 1); expected consecutive vertices to differ"},
        Refused{"point_twice", "MULTIPOINT (1 1, 2 2,\n1 1)",
                "file:2:1: point 3, (1, 1), is also point 1; expected each isolated vertex once"},
        Refused{"point_on_a_dangling_edge",
                "GEOMETRYCOLLECTION (POINT (1 1),\nLINESTRING (2 2, 0 0))",
                "file:1:28: point 1, (1, 1), lies on the dangling edge from (0, 0) to (2, 2); "
                "expected an isolated vertex"}),
    test_name);

class RefusedText : public testing::TestWithParam<Refused> {};

TEST_P(RefusedText, says_why) {
  EXPECT_EQ(refusal([&] { region_from(GetParam().text); }), GetParam().message);
  EXPECT_EQ(refusal([&] { sum_from(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Text, RefusedText,
    testing::Values(
        Refused{"empty", "",
                "file:1:1: nothing but blanks or nothing at all; expected a region in "
                ".dat, WKT or GeoJSON"},
        Refused{"blank", " \n\t\r\n",
                "file:1:1: nothing but blanks or nothing at all; expected a region in "
                ".dat, WKT or GeoJSON"},
        Refused{"binary", std::string("3 0 0\n1 \0 0 1", 13),
                "file:2:3: the byte '\\x00' is not text; expected a region in .dat, WKT "
                "or GeoJSON"},
        Refused{"compressed", "\x1f\x8b\x08",
                "file:1:1: the byte '\\x1f' is not text; expected a region in .dat, WKT "
                "or GeoJSON"}),
    test_name);

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

TEST(Reading, of_a_file_names_it) {
  const std::string path =
      testing::TempDir() + "oplus_reading_test_" + std::to_string(::getpid()) + ".wkt";
  std::ofstream(path) << "POLYGON ((0 0, 0 1, 1 0, 0 0))";
  EXPECT_EQ(
      read_region_file(path).notes,
      std::vector<std::string>({path + ": outer chain of component 1 was clockwise; turned"}));
  std::ofstream(path) << "POLYGON (0 0)";
  EXPECT_EQ(refusal([&] { read_sum_file(path); }),
            path + ":1:10: '0' in outer chain of component 1; expected '(' or EMPTY");
  std::filesystem::remove(path);
}

TEST(Reading, of_a_file_that_is_not_there_says_so) {
  const std::string path = testing::TempDir() + "no_such_folder/file.dat";
  const std::string expected =
      path + ": cannot be opened (No such file or directory); expected a file that can be read";
  EXPECT_EQ(refusal([&] { read_region_file(path); }), expected);
  EXPECT_EQ(refusal([&] { read_sum_file(path); }), expected);
}

TEST(Reading, of_a_folder_says_so) {
  EXPECT_EQ(refusal([] { read_region_file("/"); }),
            "/: cannot be read (Is a directory); expected a region in .dat, WKT or GeoJSON");
}

TEST(Reading, of_a_name_with_line_breaks_stays_in_one_line) {
  EXPECT_EQ(
      refusal([] { read_region_file("no\nfile"); }),
      "no\\x0afile: cannot be opened (No such file or directory); expected a file that can be "
      "read");
}

}  // namespace
}  // namespace oplus
