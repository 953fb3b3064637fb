// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});

TEST(ValidSet, is_a_union) {
  EXPECT_EQ(ValidSet(), ValidSet({}, {}, {}));
  EXPECT_EQ(ValidSet(square), ValidSet(square, {{{0, 0}, {"1/2", 0.5}}}, {{1, 1}}));
  EXPECT_EQ(ValidSet({}, {{{0, 0}, {2, 0}}, {{1, 0}, {4, 0}, {4, 0}}, {{5, 5}}}),
            ValidSet({}, {{{4, 0}, {0, 0}}}, {{5, 5}, {5, 5}, {3, 0}}));
  EXPECT_EQ(ValidSet(square, {{{1, 1}, {3, 1}}}).value().dangling_edges.size(), 1U);
  EXPECT_EQ(ValidSet(square).value().outer.size(), 1U);
}

TEST(ValidSet, is_read) {
  EXPECT_EQ(read_set("LINESTRING(0 0,4 0)"), ValidSet({}, {{{0, 0}, {4, 0}}}));
  EXPECT_EQ(read_set(R"({"type":"Point","coordinates":[3,4]})"), ValidSet({}, {}, {{3, 4}}));
  EXPECT_EQ(read_set("4 0 0 1 0 1 1 0 1"), ValidSet(square));
  EXPECT_THROW(read_set("LINESTRING(0 0)"), InvalidInput);
  EXPECT_THROW(read_set_file("no such file"), InvalidInput);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "closed_set_test.wkt";
  std::ofstream(file) << "MULTIPOINT(3 4,5 6)";
  EXPECT_EQ(read_set_file(file.string()), ValidSet({}, {}, {{3, 4}, {5, 6}}));
  std::filesystem::remove(file);
}

TEST(ValidSet, turns_by_pi) {
  const ValidSet set(square, {{{1, 1}, {3, 2}}}, {{7, 7}});
  EXPECT_EQ(-set, ValidSet(-square, {{{-1, -1}, {-3, -2}}}, {{-7, -7}}));
  EXPECT_EQ(-(-set), set);
  const ValidSet outside(complement(square));
  EXPECT_EQ(-outside, ValidSet(complement(-square)));
}

TEST(ValidSet, has_closed_sums_that_contain_their_edges_and_points) {
  const ValidSet lines =
      minkowski_sum(ValidSet({}, {{{0, 0}, {2, 0}}}, {{0, 9}}), ValidSet({}, {{{0, 0}, {1, 0}}}));
  EXPECT_EQ(lines.dangling_edges().size(), 2U);
  EXPECT_TRUE(contains(lines, {3, 0}));
  EXPECT_FALSE(contains(lines, {3, 1}));
  const ValidSet open = minkowski_sum(ValidSet({}, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}}),
                                      -square, {.boundary = Boundary::open});
  EXPECT_EQ(open.isolated_vertices(), std::vector<Point>(1, Point{0, 0}));
  EXPECT_FALSE(contains(open, {0, 0}));
  EXPECT_TRUE(contains(open, {0, "1/2"}));
}

}  // namespace
}  // namespace oplus
