// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/box_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "reference/families/random.hpp"

namespace oplus::slide {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Doubles that floats hold, round up and round down, of either sign.
std::vector<double> doubles() {
  std::vector<double> all{0, 1, 0.1, 0.3, 16777216, 16777217, 16777219, 0x1p60 + 0x1p10, 0x1p-30};
  all.push_back(std::nextafter(1.0, 2.0));
  all.push_back(std::nextafter(1.0, 0.0));
  all.push_back(std::nextafter(0x1p29, 0.0));
  for (std::size_t i = all.size(); i-- > 0;) all.push_back(-all[i]);
  return all;
}

double low_x(const Box& box) { return static_cast<double>(box[0]); }
double low_y(const Box& box) { return static_cast<double>(box[1]); }
double high_x(const Box& box) { return -static_cast<double>(box[2]); }
double high_y(const Box& box) { return -static_cast<double>(box[3]); }

TEST(BoxAround, contains_its_points_and_is_the_smallest_that_does) {
  const auto above = [](double f) {
    return static_cast<double>(std::nextafter(static_cast<float>(f), infinity));
  };
  const auto below = [](double f) {
    return static_cast<double>(std::nextafter(static_cast<float>(f), -infinity));
  };
  std::size_t rounded_to_the_wrong_side = 0;
  for (const double ax : doubles()) {
    for (const double bx : doubles()) {
      const double ay = -bx, by = 3 * ax;
      const Box box = box_around(ax, ay, bx, by);
      EXPECT_LE(low_x(box), std::min(ax, bx));
      EXPECT_GT(above(low_x(box)), std::min(ax, bx));
      EXPECT_LE(low_y(box), std::min(ay, by));
      EXPECT_GT(above(low_y(box)), std::min(ay, by));
      EXPECT_GE(high_x(box), std::max(ax, bx));
      EXPECT_LT(below(high_x(box)), std::max(ax, bx));
      EXPECT_GE(high_y(box), std::max(ay, by));
      EXPECT_LT(below(high_y(box)), std::max(ay, by));
      if (static_cast<double>(static_cast<float>(std::min(ax, bx))) > std::min(ax, bx))
        ++rounded_to_the_wrong_side;
    }
  }
  EXPECT_GT(rounded_to_the_wrong_side, 0u);
}

TEST(Box, contains_what_is_inside_or_on_its_boundary) {
  const Box box = box_around(-1, 2, 5, 7);
  const auto is_inside = [&](double x, double y) { return contains(box, NearPoint{x, y}.box(0)); };
  EXPECT_TRUE(is_inside(0, 3));
  for (const double x : {-1.0, 5.0}) {
    EXPECT_TRUE(is_inside(x, 2));
    EXPECT_TRUE(is_inside(x, 7));
    EXPECT_FALSE(is_inside(x, 1.75));
    EXPECT_FALSE(is_inside(x, 7.25));
  }
  EXPECT_FALSE(is_inside(-1.25, 3));
  EXPECT_FALSE(is_inside(5.25, 3));
  EXPECT_TRUE(contains(box, NearPoint{5.25, 3}.box(0.25)));
  EXPECT_TRUE(contains(box, NearPoint{-1.25, 7.25}.box(0.25)));
  EXPECT_FALSE(contains(box, NearPoint{5.5, 3}.box(0.25)));
}

TEST(Box, sums_are_around_the_sums) {
  const Box sum = box_around(0, 0, 2, 3) + box_around(10, 20, 9, 25);
  EXPECT_EQ(low_x(sum), 9);
  EXPECT_EQ(low_y(sum), 20);
  EXPECT_EQ(high_x(sum), 12);
  EXPECT_EQ(high_y(sum), 28);
}

TEST(NearPoint, is_in_a_box_that_it_is_in_but_for_rounding) {
  // What is rounded, the box's sums and the point, is off by less than the margin of 2^-20.
  Random random(6);
  for (int k = 0; k < 20000; ++k) {
    const auto number = [&] {
      const double coarse = uniform(random, -0x20000000, 0x20000000);
      return coarse + uniform(random, 0, 0x1000) * 0x1p-12;
    };
    const double ax = number(), ay = number(), bx = number(), by = number();
    const Box box = box_around(ax, ay, ax, ay) + box_around(bx, by, bx, by);
    EXPECT_TRUE(contains(box, NearPoint{ax + bx, ay + by}.box(0x1p30 * 0x1p-20)));
  }
}

class BoxTreeOf : public testing::TestWithParam<std::uint32_t> {};

std::vector<Box> some_boxes(std::uint32_t count) {
  Random random(count);
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = uniform(random, -100, 100);
    const double y = uniform(random, -100, 100);
    boxes.push_back(box_around(x, y, x + uniform(random, 0, 20), y - 0.1));
  }
  return boxes;
}

bool same(const Box& a, const Box& b) { return std::experimental::all_of(a == b); }

/// Visits the leaves under a node in order. Returns the number of levels.
std::size_t walk(const BoxTree& tree, std::uint32_t node, std::vector<std::uint32_t>& leaves) {
  const BoxTree::Node& here = tree[node];
  const double circumference =
      2 * (high_x(here.box) - low_x(here.box) + high_y(here.box) - low_y(here.box));
  EXPECT_NEAR(static_cast<double>(here.size), circumference / 2, 1e-3);
  if (here.is_leaf()) {
    leaves.push_back(here.edge);
    return 1;
  }
  EXPECT_EQ(here.edge, BoxTree::none);
  EXPECT_TRUE(same(here.box, around(tree[node + 1].box, tree[here.right].box)));
  const std::size_t left = walk(tree, node + 1, leaves);
  return 1 + std::max(left, walk(tree, here.right, leaves));
}

TEST_P(BoxTreeOf, boxes_has_each_once_in_order_and_is_balanced) {
  const std::vector<Box> boxes = some_boxes(GetParam());
  const BoxTree tree(boxes);
  std::vector<std::uint32_t> leaves;
  const std::size_t levels = walk(tree, 0, leaves);
  ASSERT_EQ(leaves.size(), boxes.size());
  for (std::uint32_t i = 0; i < leaves.size(); ++i) EXPECT_EQ(leaves[i], i);
  std::size_t least = 1;
  while (std::size_t{1} << (least - 1) < boxes.size()) ++least;
  EXPECT_EQ(levels, least);
  Box all = boxes[0];
  for (const Box& box : boxes) all = around(all, box);
  EXPECT_TRUE(same(tree[0].box, all));
}

TEST_P(BoxTreeOf, boxes_has_each_at_its_leaf) {
  const std::vector<Box> boxes = some_boxes(GetParam());
  const BoxTree tree(boxes);
  std::size_t leaves = 0;
  for (std::uint32_t node = 0; node < 2 * GetParam() - 1; ++node) {
    if (!tree[node].is_leaf()) continue;
    ++leaves;
    EXPECT_TRUE(same(tree[node].box, boxes[tree[node].edge]));
  }
  EXPECT_EQ(leaves, boxes.size());
}

INSTANTIATE_TEST_SUITE_P(Some, BoxTreeOf, testing::Values(1, 2, 3, 4, 5, 64, 100, 129),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace oplus::slide
