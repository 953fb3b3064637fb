// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/slide_check.hpp"

#include <gtest/gtest.h>

#include "properties/compare/corpus.hpp"
#include "properties/fuzz/shown_input.hpp"

namespace oplus {
namespace {

TEST(SlideCheck, finds_nothing_in_the_corpus) {
  for (const CorpusPair& row : corpus()) EXPECT_NO_THROW(check_slide({row.p, row.q})) << row.name;
}

/// What slide finds is compared as a whole: sums and origins, closed and open.
TEST(SlideCheck, throws_where_slide_and_the_expected_sums_differ) {
  const Region p = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Region q = polygon({{0, 0}, {1, 0}, {0, 1}});
  const SumsAlongLines right = sums_along_lines(p, q);
  const auto is_found = [&](const auto& change) {
    SumsAlongLines wrong = right;
    change(wrong);
    EXPECT_THROW(check_slide({p, q}, wrong, SlideLaws::as_needed), FuzzFinding);
  };
  EXPECT_NO_THROW(check_slide({p, q}, right, SlideLaws::all));
  is_found([](SumsAlongLines& sums) { sums.closed.outer[0].pop_back(); });
  is_found([](SumsAlongLines& sums) { sums.open.isolated_vertices.push_back({2, 2}); });
  is_found([](SumsAlongLines& sums) { sums.origins_of_closed[0].clear(); });
  is_found([](SumsAlongLines& sums) { sums.origins_of_open[0].clear(); });
}

/// It requires valid summands; of invalid ones both algorithms make something, and not the same.
TEST(SlideCheck, throws_for_an_invalid_region) {
  const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  const Region clockwise = polygon({{0, 0}, {0, 8}, {8, 8}, {8, 0}});
  EXPECT_ANY_THROW(check_slide({clockwise, triangle}));
}

TEST(ShownInput, of_slide_is_a_pair_and_back) {
  std::size_t held = 0;
  for (const CorpusPair& row : corpus()) {
    const auto input = input_of_pair({row.p, row.q});
    if (!input) continue;
    ++held;
    EXPECT_TRUE(pair_of_input(*input) == (Summands{row.p, row.q})) << row.name;
  }
  EXPECT_GT(held, 5U);
}

}  // namespace
}  // namespace oplus
