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

/// It requires valid summands; of invalid ones both engines make something, and not the same.
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
