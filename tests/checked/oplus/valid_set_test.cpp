// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

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

TEST(ValidSet, equals_the_same_set_in_any_form) {
  const ValidRegion turned = polygon({{1, 1}, {0, 1}, {0, 0}, {1, 0}});
  EXPECT_EQ(square, turned);
  EXPECT_EQ(ValidSet(square), turned);
  EXPECT_EQ(minkowski_sum(square, ValidRegion()).region(), ValidRegion());
  EXPECT_NE(square, polygon({{0, 0}, {1, 0}, {1, 1}}));
  const ValidRegion two = read_wkt("MULTIPOLYGON(((9 0,10 0,10 1,9 0)),((0 0,1 0,1 1,0 1,0 0)))");
  EXPECT_EQ(two, read_wkt("MULTIPOLYGON(((0 0,1 0,1 1,0 1,0 0)),((10 0,10 1,9 0,10 0)))"));
}

TEST(ValidSet, that_is_open_is_no_summand_with_edges_or_vertices_of_its_own) {
  const ValidRegion frame =
      polygon({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}});
  const SumOptions open{.boundary = Boundary::open};
  const ValidSet fits = minkowski_sum(frame, -square, open);
  ASSERT_EQ(fits.isolated_vertices().size(), 1U);
  EXPECT_THROW(minkowski_sum(fits, ValidSet(square)), InvalidInput);
  const ValidRegion flat = polygon({{0, 0}, {1, 0}, {1, "1/2"}, {0, "1/2"}});
  const ValidSet slides = minkowski_sum(frame, flat, open);
  ASSERT_EQ(slides.dangling_edges().size(), 1U);
  EXPECT_THROW(minkowski_sum(slides, ValidSet(square)), InvalidInput);
  EXPECT_EQ(minkowski_sum(minkowski_sum(square, square, open), ValidSet(square)),
            minkowski_sum(minkowski_sum(square, square).region(), square));
}

TEST(ValidSet, of_any_extent_has_text) {
  EXPECT_EQ(to_dat(complement(square)), "0\n1\n4\n0 0\n0 1\n1 1\n1 0\n");
  EXPECT_EQ(read_text(to_dat(complement(minkowski_sum(square, square)))),
            complement(minkowski_sum(square, square).region()));
  EXPECT_THROW(to_dat(ValidSet({}, {{{0, 0}, {1, 0}}})), std::invalid_argument);
}

TEST(ValidSet, takes_time_that_is_told_and_can_be_ended) {
  struct Stop {};
  std::vector<Coordinates> outer;
  for (int i = 0; i < 200; ++i) {
    outer.emplace_back(i, 0);
    outer.emplace_back(i + 0.5, 100 + i);
  }
  outer.emplace_back(201, -1);
  outer.emplace_back(-1, -1);
  const ValidRegion comb = polygon(outer);
  std::size_t last = 0, all = 0;
  const ValidSet told =
      minkowski_sum(comb, -comb, {.progress = [&](std::size_t done, std::size_t total) {
                      last = std::max(last, done), all = total;
                    }});
  EXPECT_GT(all, 0U);
  EXPECT_EQ(last, all);
  EXPECT_EQ(told, minkowski_sum(comb, -comb));
  EXPECT_THROW(minkowski_sum(comb, -comb, {.progress = [](auto...) { throw Stop(); }}), Stop);
}

TEST(ClaimedSum, is_read_as_it_is) {
  const ClaimedSum claimed =
      read_claimed_sum("GEOMETRYCOLLECTION(POLYGON((0 0,2 2,2 0,0 2,0 0)),POINT(7 7))");
  EXPECT_EQ(claimed.region.components.size(), 1U);
  EXPECT_EQ(claimed.isolated_vertices.size(), 1U);
  EXPECT_THROW(read_claimed_sum("POLYGON((0 0"), InvalidInput);
}

}  // namespace
}  // namespace oplus
