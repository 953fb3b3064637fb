// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
  std::vector<std::vector<int>> seen;
  for (int i = 0; i < 300; ++i) {
    std::vector<int> order{1, 2, 3, 4};
    shuffle(random, order);
    if (std::find(seen.begin(), seen.end(), order) == seen.end()) seen.push_back(order);
  }
  EXPECT_EQ(seen.size(), 24u);
  for (std::vector<int> order : seen) {
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (std::vector<int>{1, 2, 3, 4}));
  }
}

}  // namespace
}  // namespace oplus
