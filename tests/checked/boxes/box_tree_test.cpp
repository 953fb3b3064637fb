// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/boxes/box_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace oplus {
namespace {

template <std::uint32_t leaf_size>
void check(const BoxTree<leaf_size>& tree, const std::vector<Box>& list,
           const typename BoxTree<leaf_size>::Range& range, std::vector<int>& seen) {
  Box all;
  double sizes = 0;
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    all = around(all, list[i]);
    sizes += list[i].size();
  }
  EXPECT_EQ(tree[range].low_x, all.low_x);
  EXPECT_EQ(tree[range].high_x, all.high_x);
  EXPECT_EQ(tree[range].low_y, all.low_y);
  EXPECT_EQ(tree[range].high_y, all.high_y);
  EXPECT_DOUBLE_EQ(tree.slack(range), all.size() - sizes / range.size());
  ASSERT_LT(range.node, seen.size());
  ++seen[range.node];
  EXPECT_EQ(range.is_leaf(), range.size() <= leaf_size);
  if (range.is_leaf()) return;
  const auto [first, second] = range.halves();
  EXPECT_EQ(first.begin, range.begin);
  EXPECT_EQ(first.end, second.begin);
  EXPECT_EQ(second.end, range.end);
  check(tree, list, first, seen);
  check(tree, list, second, seen);
}

template <std::uint32_t leaf_size>
void check_trees() {
  EXPECT_TRUE(BoxTree<leaf_size>().empty());
  for (const std::uint32_t size : {1U, 2U, 3U, 4U, 5U, 8U, 13U, 31U}) {
    std::vector<Box> list;
    for (std::uint32_t i = 0; i < size; ++i) {
      const double x = i * 5 % 7, y = i * 3 % 11;
      list.push_back({x, y, x + 1, y + 2});
    }
    const BoxTree<leaf_size> tree(list);
    std::vector<int> seen(2 * list.size(), 0);
    check(tree, list, tree.all(), seen);
    EXPECT_LE(*std::max_element(seen.begin(), seen.end()), 1);
  }
}

TEST(BoxTree, has_boxes_around_halves_each_in_a_place_of_its_own) {
  check_trees<1>();
  check_trees<4>();
}

}  // namespace
}  // namespace oplus
