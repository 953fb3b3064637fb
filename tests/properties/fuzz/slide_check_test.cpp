// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/slide_check.hpp"

#include <gtest/gtest.h>

#include "properties/compare/corpus.hpp"
#include "reference/definitions/convolution.hpp"

namespace oplus {
namespace {

TEST(SlideCheck, finds_nothing_in_the_corpus) {
  for (const CorpusPair& row : corpus()) EXPECT_NO_THROW(check_slide({row.p, row.q})) << row.name;
}

/// What slide finds is compared as a whole: sums and origins, closed and open.
TEST(SlideCheck, throws_where_slide_and_the_expected_sums_differ) {
  const Region p = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Region q = polygon({{0, 0}, {1, 0}, {0, 1}});
  const ExpectedSums right = expected_sums({p, q});
  const auto is_found = [&](const auto& change) {
    ExpectedSums wrong = right;
    change(wrong);
    EXPECT_THROW(check_slide({p, q}, wrong, SlideLaws::as_needed), FuzzFinding);
  };
  EXPECT_NO_THROW(check_slide({p, q}, right, SlideLaws::all));
  is_found([](ExpectedSums& sums) { sums.closed.outer[0].pop_back(); });
  is_found([](ExpectedSums& sums) { sums.open.isolated_vertices.push_back({2, 2}); });
  is_found([](ExpectedSums& sums) { sums.origins_of_closed[0].clear(); });
  is_found([](ExpectedSums& sums) { sums.origins_of_open[0].clear(); });
}

/// Closed sums are derived from the open ones.
TEST(ExpectedSums, are_those_of_the_oracle) {
  for (const CorpusPair& row : corpus()) {
    const ExpectedSums found = expected_sums({row.p, row.q});
    EXPECT_TRUE(found.closed == row.closed) << row.name;
    EXPECT_TRUE(found.open == row.open) << row.name;
    const auto reduced = reduced_convolution(row.p, row.q);
    EXPECT_EQ(found.origins_of_closed, origins(row.closed, reduced)) << row.name;
    EXPECT_EQ(found.origins_of_open, origins(row.open, reduced)) << row.name;
  }
}

}  // namespace
}  // namespace oplus
