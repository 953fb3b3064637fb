// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});

TEST(ClosedSet, is_a_union) {
  EXPECT_EQ(ClosedSet(), ClosedSet({}, {}, {}));
  EXPECT_EQ(ClosedSet(square), ClosedSet(square, {{{0, 0}, {"1/2", 0.5}}}, {{1, 1}}));
  EXPECT_EQ(ClosedSet({}, {{{0, 0}, {2, 0}}, {{1, 0}, {4, 0}, {4, 0}}, {{5, 5}}}),
            ClosedSet({}, {{{4, 0}, {0, 0}}}, {{5, 5}, {5, 5}, {3, 0}}));
  EXPECT_EQ(ClosedSet(square, {{{1, 1}, {3, 1}}}).value().dangling_edges.size(), 1U);
  EXPECT_EQ(ClosedSet(square).value().outer.size(), 1U);
}

TEST(ClosedSet, is_read) {
  EXPECT_EQ(read_set("LINESTRING(0 0,4 0)"), ClosedSet({}, {{{0, 0}, {4, 0}}}));
  EXPECT_EQ(read_set(R"({"type":"Point","coordinates":[3,4]})"), ClosedSet({}, {}, {{3, 4}}));
  EXPECT_EQ(read_set("4 0 0 1 0 1 1 0 1"), ClosedSet(square));
  EXPECT_THROW(read_set("LINESTRING(0 0)"), InvalidInput);
  EXPECT_THROW(read_set_file("no such file"), InvalidInput);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "closed_set_test.wkt";
  std::ofstream(file) << "MULTIPOINT(3 4,5 6)";
  EXPECT_EQ(read_set_file(file.string()), ClosedSet({}, {}, {{3, 4}, {5, 6}}));
  std::filesystem::remove(file);
}

TEST(ClosedSet, turns_by_pi) {
  const ClosedSet set(square, {{{1, 1}, {3, 2}}}, {{7, 7}});
  EXPECT_EQ(-set, ClosedSet(-square, {{{-1, -1}, {-3, -2}}}, {{-7, -7}}));
  EXPECT_EQ(-(-set), set);
  const ClosedSet outside(complement(square));
  EXPECT_EQ(-outside, ClosedSet(complement(-square)));
}

TEST(ClosedSet, is_summed) {
  const ClosedSet path({}, {{{0, 0}, {4, 0}, {4, 3}}});
  const Sum swept = minkowski_sum(path, square);
  EXPECT_EQ(to_wkt(swept), "POLYGON ((0 0, 5 0, 5 4, 4 4, 4 1, 0 1, 0 0))");
  EXPECT_EQ(area(swept), 8);
  EXPECT_EQ(minkowski_sum(ClosedSet(square), square), minkowski_sum(square, square));
}

TEST(ClosedSet, has_closed_sums_that_contain_their_edges_and_points) {
  const Sum lines =
      minkowski_sum(ClosedSet({}, {{{0, 0}, {2, 0}}}, {{0, 9}}), ClosedSet({}, {{{0, 0}, {1, 0}}}));
  EXPECT_EQ(lines.dangling_edges().size(), 2U);
  EXPECT_TRUE(contains(lines, {3, 0}));
  EXPECT_FALSE(contains(lines, {3, 1}));
  const Sum open = minkowski_sum(ClosedSet({}, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}}), -square,
                                 {.boundary = Boundary::open});
  EXPECT_EQ(open.isolated_vertices(), std::vector<Point>(1, Point{0, 0}));
  EXPECT_FALSE(contains(open, {0, 0}));
  EXPECT_TRUE(contains(open, {0, "1/2"}));
}

}  // namespace
}  // namespace oplus
