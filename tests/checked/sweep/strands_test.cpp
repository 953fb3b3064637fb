// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/sweep/strands.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace oplus {
namespace {

using Indices = std::vector<std::uint32_t>;

TEST(Strands, keep_a_segment_that_overlaps_no_other_and_turn_it_upwards) {
  const std::vector<Strand> result = strands({{{2, 3}, {0, 1}}});
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(result[0].segment, (Segment{{0, 1}, {2, 3}}));
  EXPECT_EQ(result[0].along, Indices{});
  EXPECT_EQ(result[0].against, Indices{0});
}

TEST(Strands, are_cut_where_an_overlap_begins_and_ends) {
  const std::vector<Strand> result = strands({{{0, 0}, {6, 3}}, {{8, 4}, {4, 2}}});
  ASSERT_EQ(result.size(), 3U);
  EXPECT_EQ(result[0].segment, (Segment{{0, 0}, {4, 2}}));
  EXPECT_EQ(result[1].segment, (Segment{{4, 2}, {6, 3}}));
  EXPECT_EQ(result[2].segment, (Segment{{6, 3}, {8, 4}}));
  EXPECT_EQ(result[1].along, Indices{0});
  EXPECT_EQ(result[1].against, Indices{1});
  EXPECT_EQ(result[2].along, Indices{});
  EXPECT_EQ(result[2].against, Indices{1});
}

TEST(Strands, join_equal_vertical_segments) {
  const std::vector<Strand> result =
      strands({{{1, 0}, {1, 2}}, {{1, 2}, {1, 0}}, {{1, 0}, {1, 2}}});
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(result[0].along, (Indices{0, 2}));
  EXPECT_EQ(result[0].against, Indices{1});
}

TEST(Strands, leave_parallel_collinear_and_crossing_segments_alone_that_do_not_overlap) {
  const std::vector<Segment> apart = {
      {{0, 0}, {1, 0}}, {{2, 0}, {3, 0}}, {{3, 0}, {4, 0}}, {{0, 1}, {4, 1}}, {{2, -1}, {2, 2}}};
  const std::vector<Strand> result = strands(apart);
  EXPECT_EQ(result.size(), apart.size());
  for (const Segment& s : apart) {
    EXPECT_EQ(std::count_if(result.begin(), result.end(),
                            [&](const Strand& strand) {
                              return strand.segment == s && strand.along.size() == 1 &&
                                     strand.against.empty();
                            }),
              1);
  }
}

TEST(Strands, of_one_line_do_not_mix_with_those_of_a_parallel_one) {
  const std::vector<Strand> result = strands({{{0, 0}, {3, 1}}, {{0, 1}, {3, 2}}});
  ASSERT_EQ(result.size(), 2U);
  for (const Strand& strand : result) EXPECT_EQ(strand.along.size(), 1U);
}

}  // namespace
}  // namespace oplus
