// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/boxes/halving_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace oplus {
namespace {

TEST(HalvingOrder, first_half_is_a_power_of_two) {
  EXPECT_EQ(first_half(2), 1U);
  EXPECT_EQ(first_half(3), 2U);
  EXPECT_EQ(first_half(4), 2U);
  EXPECT_EQ(first_half(5), 4U);
  EXPECT_EQ(first_half(100), 64U);
}

/// In a grid of 8 x 8 boxes, which share a corner, each four that follow one another have their middles in a square.
TEST(HalvingOrder, neighbours_are_near) {
  std::vector<Box> boxes;
  for (int i = 0; i < 64; ++i) boxes.push_back({-1, -1, 1.0 + i * 5 % 8, 1.0 + i * 5 / 8 % 8});
  const std::vector<std::uint32_t> order = halving_order(boxes);
  for (std::size_t first = 0; first < 64; first += 4) {
    double width = 0, height = 0;
    for (std::size_t a = first; a < first + 4; ++a) {
      for (std::size_t b = first; b < first + 4; ++b) {
        width = std::max(width, boxes[order[a]].high_x - boxes[order[b]].high_x);
        height = std::max(height, boxes[order[a]].high_y - boxes[order[b]].high_y);
      }
    }
    EXPECT_EQ(width, 1);
    EXPECT_EQ(height, 1);
  }
}

TEST(HalvingOrder, of_nothing_and_of_one) {
  EXPECT_TRUE(halving_order({}).empty());
  EXPECT_EQ(halving_order(std::vector<Box>{{1, 2, 3, 4}}), std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace oplus
