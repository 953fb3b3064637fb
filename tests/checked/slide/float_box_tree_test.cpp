// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/float_box_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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

double low_x(const FloatBox& box) { return static_cast<double>(box[0]); }
double low_y(const FloatBox& box) { return static_cast<double>(box[1]); }
double high_x(const FloatBox& box) { return -static_cast<double>(box[2]); }
double high_y(const FloatBox& box) { return -static_cast<double>(box[3]); }

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
      const FloatBox box = box_around(ax, ay, bx, by);
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

TEST(FloatBox, contains_what_is_inside_or_on_its_boundary) {
  const FloatBox box = box_around(-1, 2, 5, 7);
  const auto is_inside = [&](double x, double y) {
    return contains(box, ApproximatePoint{x, y}.box());
  };
  EXPECT_TRUE(is_inside(0, 3));
  for (const double x : {-1.0, 5.0}) {
    EXPECT_TRUE(is_inside(x, 2));
    EXPECT_TRUE(is_inside(x, 7));
    EXPECT_FALSE(is_inside(x, 1.75));
    EXPECT_FALSE(is_inside(x, 7.25));
  }
  EXPECT_FALSE(is_inside(-1.25, 3));
  EXPECT_FALSE(is_inside(5.25, 3));
  EXPECT_TRUE(contains(box, ApproximatePoint{5.25, 3, 0.25}.box()));
  EXPECT_TRUE(contains(box, ApproximatePoint{-1.25, 7.25, 0.25}.box()));
  EXPECT_FALSE(contains(box, ApproximatePoint{5.5, 3, 0.25}.box()));
}

TEST(FloatBox, sums_are_around_the_sums) {
  const FloatBox sum = box_around(0, 0, 2, 3) + box_around(10, 20, 9, 25);
  EXPECT_EQ(low_x(sum), 9);
  EXPECT_EQ(low_y(sum), 20);
  EXPECT_EQ(high_x(sum), 12);
  EXPECT_EQ(high_y(sum), 28);
}

TEST(ApproximatePoint, is_in_a_box_that_it_is_in_but_for_rounding) {
  Random random(6);
  for (int k = 0; k < 20000; ++k) {
    const auto number = [&] {
      const double coarse = uniform(random, -0x20000000, 0x20000000);
      return coarse + uniform(random, 0, 0x1000) * 0x1p-12;
    };
    const double ax = number(), ay = number(), bx = number(), by = number();
    const FloatBox box = box_around(ax, ay, ax, ay) + box_around(bx, by, bx, by);
    EXPECT_TRUE(contains(box, ApproximatePoint{ax + bx, ay + by}.box()));
  }
}

class BoxTreeOf : public testing::TestWithParam<std::uint32_t> {};

std::vector<FloatBox> some_boxes(std::uint32_t count) {
  Random random(count);
  std::vector<FloatBox> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = uniform(random, -100, 100);
    const double y = uniform(random, -100, 100);
    boxes.push_back(box_around(x, y, x + uniform(random, 0, 20), y - 0.1));
  }
  return boxes;
}

bool same(const FloatBox& a, const FloatBox& b) { return contains(a, b) && contains(b, a); }

/// Visits the leaves under a node in order. Returns the number of levels.
std::size_t walk(const FloatBoxTree& tree, std::uint32_t node, std::vector<std::uint32_t>& leaves) {
  const FloatBoxTree::Node& here = tree[node];
  const double circumference =
      2 * (high_x(here.box) - low_x(here.box) + high_y(here.box) - low_y(here.box));
  EXPECT_LE(static_cast<double>(here.size), circumference / 2 + 1e-3);
  EXPECT_GE(static_cast<double>(here.size), circumference / (here.is_leaf() ? 2 : 128) - 1e-3);
  EXPECT_EQ(here.strip, FloatBoxTree::none);
  if (here.is_leaf()) {
    leaves.push_back(here.edge);
    return 1;
  }
  EXPECT_EQ(here.edge, FloatBoxTree::none);
  EXPECT_TRUE(same(here.box, around(tree[node + 1].box, tree[here.right].box)));
  const std::size_t left = walk(tree, node + 1, leaves);
  return 1 + std::max(left, walk(tree, here.right, leaves));
}

TEST_P(BoxTreeOf, boxes_has_each_once_and_is_balanced) {
  const std::vector<FloatBox> boxes = some_boxes(GetParam());
  const FloatBoxTree tree(boxes);
  std::vector<std::uint32_t> leaves;
  const std::size_t levels = walk(tree, 0, leaves);
  std::sort(leaves.begin(), leaves.end());
  ASSERT_EQ(leaves.size(), boxes.size());
  for (std::uint32_t i = 0; i < leaves.size(); ++i) EXPECT_EQ(leaves[i], i);
  std::size_t least = 1;
  while (std::size_t{1} << (least - 1) < boxes.size()) ++least;
  EXPECT_EQ(levels, least);
  FloatBox all = boxes[0];
  for (const FloatBox& box : boxes) all = around(all, box);
  EXPECT_TRUE(same(tree[0].box, all));
}

TEST(FloatBoxTree, does_not_depend_on_the_number_of_threads) {
  Random random(1);
  std::vector<FloatBox> boxes;
  std::vector<NearSegment> edges;
  for (int i = 0; i < 9000; ++i) {
    const double x = i, y = uniform(random, 0, 3000), dx = 1, dy = uniform(random, -3000, 3000);
    edges.push_back({x, y, dx, dy});
    boxes.push_back(box_around(x, y, x + dx, y + dy));
  }
  const std::vector<std::uint32_t> chains = {0, 3000, 3003};
  const FloatBoxTree one(boxes, edges, chains);
  std::size_t strips = 0;
  for (const unsigned threads : {2u, 3u, 8u}) {
    const FloatBoxTree many(boxes, edges, chains, threads);
    ASSERT_EQ(many.size(), one.size());
    for (std::uint32_t node = 0; node < one.size(); ++node) {
      const FloatBoxTree::Node &a = one[node], &b = many[node];
      ASSERT_TRUE(same(a.box, b.box) && a.edge == b.edge && a.right == b.right &&
                  a.size == b.size && a.strip == b.strip)
          << node;
      if (a.strip == FloatBoxTree::none) continue;
      ++strips;
      const Strip &s = one.strip(a.strip), &t = many.strip(a.strip);
      ASSERT_TRUE(s.dx == t.dx && s.dy == t.dy && s.low == t.low && s.high == t.high) << node;
    }
  }
  EXPECT_GT(strips, 50u);
}

TEST(FloatBoxTree, takes_a_node_for_small_whose_halves_are_as_large) {
  const auto row_of_boxes = [](double height) {
    std::vector<FloatBox> boxes;
    for (int i = 0; i < 64; ++i) boxes.push_back(box_around(i, 0, i + 1, height));
    return FloatBoxTree(boxes);
  };
  EXPECT_EQ(row_of_boxes(1)[0].size, 65);
  EXPECT_EQ(row_of_boxes(1000)[0].size, 8 * 64);
  EXPECT_EQ(row_of_boxes(100'000)[0].size, 100'064.0F / 64);
}

TEST_P(BoxTreeOf, boxes_has_each_at_its_leaf) {
  const std::vector<FloatBox> boxes = some_boxes(GetParam());
  const FloatBoxTree tree(boxes);
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

/// Unit squares in a row.
std::vector<FloatBox> squares(const std::vector<int>& places) {
  std::vector<FloatBox> boxes;
  for (const int x : places) boxes.push_back(box_around(x, 0, x + 1, 1));
  return boxes;
}

std::vector<std::uint32_t> leaves_of(const FloatBoxTree& tree) {
  std::vector<std::uint32_t> leaves;
  walk(tree, 0, leaves);
  return leaves;
}

/// The number of nodes whose boxes contain a point.
std::size_t nodes_at(const FloatBoxTree& tree, const ApproximatePoint& point,
                     std::uint32_t node = 0) {
  if (!contains(tree[node].box, point.box())) return 0;
  if (tree[node].is_leaf()) return 1;
  return 1 + nodes_at(tree, point, node + 1) + nodes_at(tree, point, tree[node].right);
}

TEST(FloatBoxTree, halves_by_place_what_is_in_random_order_and_leaves_the_boundary_in_order) {
  std::vector<int> places(1000);
  std::iota(places.begin(), places.end(), 0);
  const FloatBoxTree in_order(squares(places));
  const std::vector<std::uint32_t> leaves = leaves_of(in_order);
  EXPECT_TRUE(std::is_sorted(leaves.begin(), leaves.end()));

  Random random(4);
  shuffle(random, places);
  const FloatBoxTree by_place(squares(places));
  for (const double x : {0.5, 123.5, 500.5, 999.5})
    EXPECT_LE(nodes_at(by_place, {x, 0.5}), 3 * nodes_at(in_order, {x, 0.5})) << x;
}

TEST(FloatBoxTree, divides_rings_into_their_sides) {
  std::vector<FloatBox> boxes;
  for (int r = 1; r <= 1000; ++r) {
    boxes.push_back(box_around(-r, -r, r, -r));
    boxes.push_back(box_around(r, -r, r, r));
    boxes.push_back(box_around(-r, r, r, r));
    boxes.push_back(box_around(-r, -r, -r, r));
  }
  const FloatBoxTree tree(boxes);
  for (const ApproximatePoint& at :
       {ApproximatePoint{0, 0}, ApproximatePoint{10, 500}, ApproximatePoint{-999, 3}})
    EXPECT_LE(nodes_at(tree, at), 300u) << at.x;
}

TEST(FloatBoxTree, keeps_chains_together_and_has_few_levels) {
  std::vector<int> places(500);
  std::iota(places.begin(), places.end(), 0);
  Random random(5);
  shuffle(random, places);
  std::vector<FloatBox> boxes;
  std::vector<std::uint32_t> chains;
  const auto begin_chain = [&] { chains.push_back(static_cast<std::uint32_t>(boxes.size())); };
  for (const int place : places) {
    begin_chain();
    for (int i = 0; i < 5; ++i)
      boxes.push_back(box_around(10 * place + i, i, 10 * place + i + 1, i));
    if (chains.size() != 100) continue;
    begin_chain();
    for (int i = 0; i < 5000; ++i) boxes.push_back(box_around(i, 6, i + 1, 7));
  }
  const FloatBoxTree tree(boxes, {}, chains);
  std::vector<std::uint32_t> leaves;
  EXPECT_LE(walk(tree, 0, leaves), 26u);
  ASSERT_EQ(leaves.size(), boxes.size());
  const auto chain = [&](std::uint32_t edge) {
    return std::upper_bound(chains.begin(), chains.end(), edge) - chains.begin();
  };
  std::size_t changes = 0;
  for (std::size_t k = 1; k < leaves.size(); ++k)
    changes += chain(leaves[k - 1]) != chain(leaves[k]);
  EXPECT_EQ(changes, chains.size() - 1);
  std::sort(leaves.begin(), leaves.end());
  for (std::uint32_t i = 0; i < leaves.size(); ++i) ASSERT_EQ(leaves[i], i);
}

/// Of a comb with slanted teeth, each from the baseline to the top and back.
std::vector<NearSegment> slanted_teeth(int count, double scale) {
  std::vector<NearSegment> edges;
  for (int i = 0; i < count; ++i) {
    edges.push_back({4 * i * scale, 0, 1001 * scale, 1000 * scale});
    edges.push_back({(4 * i + 1001) * scale, 1000 * scale, -999 * scale, -1000 * scale});
  }
  return edges;
}

std::vector<FloatBox> boxes_around(const std::vector<NearSegment>& edges) {
  std::vector<FloatBox> boxes;
  for (const NearSegment& e : edges) boxes.push_back(box_around(e.x, e.y, e.x + e.dx, e.y + e.dy));
  return boxes;
}

/// Checks that all edges under each node are in its strip. Returns how many have one.
std::size_t check_strips(const FloatBoxTree& tree, const std::vector<NearSegment>& edges) {
  std::size_t strips = 0;
  for (std::uint32_t node = 0; node < 2 * edges.size() - 1; ++node) {
    if (tree[node].strip == FloatBoxTree::none) continue;
    ++strips;
    const Strip& strip = tree.strip(tree[node].strip);
    std::vector<std::uint32_t> nodes{node};
    while (!nodes.empty()) {
      const std::uint32_t next = nodes.back();
      nodes.pop_back();
      if (!tree[next].is_leaf()) {
        nodes.insert(nodes.end(), {next + 1, tree[next].right});
        continue;
      }
      const NearSegment& e = edges[tree[next].edge];
      for (const double t : {0.0, 1.0}) {
        const double place = strip.dx * (e.y + t * e.dy) - strip.dy * (e.x + t * e.dx);
        EXPECT_LE(strip.low, place);
        EXPECT_GE(strip.high, place);
      }
    }
  }
  return strips;
}

TEST(FloatBoxTree, has_strips_where_boxes_are_much_wider) {
  for (const double scale : {1.0, 0x1p50}) {
    const std::vector<NearSegment> teeth = slanted_teeth(64, scale);
    EXPECT_GT(check_strips(FloatBoxTree(boxes_around(teeth), teeth), teeth), 60u);
  }
  std::vector<NearSegment> upright = slanted_teeth(64, 1);
  for (NearSegment& e : upright) e.dx = 0;
  EXPECT_EQ(check_strips(FloatBoxTree(boxes_around(upright), upright), upright), 0u);
}

}  // namespace
}  // namespace oplus::slide
