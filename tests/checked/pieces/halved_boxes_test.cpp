// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/pieces/halved_boxes.hpp"

#include <gtest/gtest.h>

namespace oplus::pieces {
namespace {

void check(const HalvedBoxes& boxes, const std::vector<Box>& list, const HalvedBoxes::Range& range,
           std::vector<int>& seen) {
  Box around;
  double sizes = 0;
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    around.add(list[i]);
    sizes += list[i].size();
  }
  EXPECT_EQ(boxes[range].x_low, around.x_low);
  EXPECT_EQ(boxes[range].x_high, around.x_high);
  EXPECT_EQ(boxes[range].y_low, around.y_low);
  EXPECT_EQ(boxes[range].y_high, around.y_high);
  EXPECT_DOUBLE_EQ(boxes.slack(range), around.size() - sizes / (range.end - range.begin));
  ASSERT_LT(range.box, seen.size());
  ++seen[range.box];
  if (range.is_one()) return;
  const auto [first, second] = range.halves();
  EXPECT_EQ(first.begin, range.begin);
  EXPECT_EQ(first.end, second.begin);
  EXPECT_EQ(second.end, range.end);
  check(boxes, list, first, seen);
  check(boxes, list, second, seen);
}

TEST(HalvedBoxes, are_around_halves_each_in_a_place_of_its_own) {
  EXPECT_TRUE(HalvedBoxes({}).empty());
  for (const std::uint32_t size : {1U, 2U, 3U, 8U, 13U}) {
    std::vector<Box> list;
    for (std::uint32_t i = 0; i < size; ++i) {
      const double x = i * 5 % 7, y = i * 3 % 11;
      list.push_back({x, x + 1, y, y + 2});
    }
    const HalvedBoxes boxes(list);
    std::vector<int> seen(2 * list.size(), 0);
    check(boxes, list, boxes.all(), seen);
    EXPECT_LE(*std::max_element(seen.begin(), seen.end()), 1);
  }
}

}  // namespace
}  // namespace oplus::pieces
