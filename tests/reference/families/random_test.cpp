// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace oplus {
namespace {

TEST(Random, same_seed_same_numbers_everywhere) {
  Random random(2026);
  std::vector<int> drawn;
  for (int i = 0; i < 8; ++i) drawn.push_back(uniform(random, -50, 50));
  EXPECT_EQ(drawn, (std::vector<int>{-18, 16, -2, 26, -25, 19, -21, 43}));
}

TEST(Random, uniform_reaches_both_ends_about_equally_often) {
  Random random(1);
  std::array<int, 6> count{};
  for (int i = 0; i < 6000; ++i) ++count.at(static_cast<std::size_t>(uniform(random, 0, 5)));
  for (const int of_value : count) {
    EXPECT_GT(of_value, 850);
    EXPECT_LT(of_value, 1150);
  }
}

TEST(Random, shuffle_reaches_every_order) {
  Random random(1);
  std::set<std::vector<int>> seen;
  for (int i = 0; i < 300; ++i) {
    std::vector<int> order{1, 2, 3, 4};
    shuffle(random, order);
    EXPECT_EQ((std::set<int>(order.begin(), order.end())), (std::set<int>{1, 2, 3, 4}));
    seen.insert(order);
  }
  EXPECT_EQ(seen.size(), 24u);
}

}  // namespace
}  // namespace oplus
