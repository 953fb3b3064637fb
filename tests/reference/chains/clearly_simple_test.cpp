// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/clearly_simple.hpp"

#include <gtest/gtest.h>

#include "tests/reference/chains/defects_of_all_pairs.hpp"
#include "tests/reference/chains/random_regions.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

bool is_clearly_simple(const Chain& chain) {
  std::vector<NearPoint> points;
  for (const Point& p : chain) points.push_back(near_point(p));
  return is_clearly_simple(points);
}

TEST(ClearlySimple, are_chains_without_a_defect_and_all_of_these_whose_edges_keep_their_distance) {
  Random random(27);
  std::size_t simple = 0, clearly = 0;
  for (int i = 0; i < 4000; ++i) {
    const Chain chain = random_chain(random, uniform(random, 2, 10));
    const bool is_simple = DefectsOfAllPairs(polygon(chain)).empty();
    simple += is_simple;
    if (!is_clearly_simple(chain)) continue;
    ++clearly;
    ASSERT_TRUE(is_simple) << testing::PrintToString(chain);
  }
  // Edges in line, whose common vertex is no corner, are not clear.
  EXPECT_GT(clearly, simple * 9 / 10);
  EXPECT_LT(simple, 3600U);
}

TEST(ClearlySimple, is_no_long_chain_nor_what_doubles_do_not_tell) {
  const Rational tiny = 1 / Rational("1" + std::string(400, '0'));
  EXPECT_TRUE(is_clearly_simple({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}));
  EXPECT_FALSE(is_clearly_simple({{0, 0}, {4, 0}, {4, 4}, {2, tiny}, {0, 4}}));
  EXPECT_FALSE(is_clearly_simple({{0, 0}, {4, 0}, {4, 4}, {2, -tiny}, {0, 4}}));
  Chain zigzag{{0, 100}};
  for (int i = 0; i < 30; ++i) zigzag.push_back({i, i % 2});
  EXPECT_FALSE(is_clearly_simple(zigzag));
}

}  // namespace
}  // namespace oplus
