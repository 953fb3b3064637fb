// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/point_grid.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/random.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus::slide {
namespace {

/// Points and what a grid knows of them: doubles that are off by little.
struct Points {
  std::vector<Point> exact;
  std::vector<double> near_x, near_y;

  void add(int x, int y, double off = 0) {
    exact.push_back({x, y});
    near_x.push_back(x + off);
    near_y.push_back(y - off);
  }
};

std::vector<std::uint32_t> visited(const Points& points, std::uint32_t a, std::uint32_t b) {
  std::vector<std::uint32_t> all;
  PointGrid(points.near_x, points.near_y).each_near_segment(a, b, [&](std::uint32_t i) {
    all.push_back(i);
  });
  return all;
}

/// Every point on a segment is visited, and none twice, whichever two points the segment is between.
void expect_complete(const Points& points) {
  const auto count = static_cast<std::uint32_t>(points.exact.size());
  for (std::uint32_t a = 0; a < count; ++a) {
    for (std::uint32_t b = 0; b < count; ++b) {
      if (a == b) continue;
      const std::vector<std::uint32_t> all = visited(points, a, b);
      const std::set<std::uint32_t> distinct(all.begin(), all.end());
      EXPECT_EQ(distinct.size(), all.size()) << "a point twice";
      const Segment segment{points.exact[a], points.exact[b]};
      for (std::uint32_t i = 0; i < count; ++i) {
        if (!lies_on(points.exact[i], segment)) continue;
        EXPECT_TRUE(distinct.contains(i))
            << testing::PrintToString(points.exact[i]) << testing::PrintToString(segment);
      }
    }
  }
}

TEST(PointGrid, visits_all_on_a_segment_of_a_small_grid) {
  Random random(8);
  for (int k = 0; k < 60; ++k) {
    Points points;
    const int side = uniform(random, 2, 6);
    for (int x = 0; x < side; ++x)
      for (int y = 0; y < side; ++y)
        if (!one_in(random, 3)) points.add(x, y);
    expect_complete(points);
  }
}

TEST(PointGrid, visits_all_on_a_segment_where_doubles_are_off) {
  Random random(9);
  for (const int far : {1, 1000, 500'000'000}) {
    for (int k = 0; k < 30; ++k) {
      Points points;
      for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 5; ++y)
          if (!one_in(random, 3))
            points.add(far + x, far + y, far * 0x1p-50 * uniform(random, -100, 100) / 100);
      expect_complete(points);
    }
  }
}

TEST(PointGrid, of_points_in_line) {
  for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {3, -1}, {-1, 7}, {1000, 1}}) {
    Points points;
    for (int i : {0, 5, 1, 9, 2, 3, 7}) points.add(4 + i * dx, i * dy - 2);
    expect_complete(points);
  }
}

TEST(PointGrid, of_few_points_or_none) {
  Points one;
  one.add(3, 4);
  EXPECT_EQ(visited(one, 0, 0), (std::vector<std::uint32_t>{0}));
  Points two;
  two.add(3, 4);
  two.add(-1, 0);
  expect_complete(two);
  const Points none;
  const PointGrid grid(none.near_x, none.near_y);
}

TEST(PointGrid, far_from_the_origin_and_crowded_in_a_corner) {
  Points points;
  for (int i = 0; i < 20; ++i) points.add(500000000 + i, 400000000 + i * i);
  for (int i = 0; i < 5; ++i) points.add(500000000 + 2 * i, 400000000 + 2 * i);
  points.add(-500000000, -600000000);
  expect_complete(points);
}

TEST(PointGrid, does_not_visit_most_that_are_far_away) {
  Points points;
  for (int x = 0; x < 30; ++x)
    for (int y = 0; y < 30; ++y) points.add(x, y);
  // A diagonal runs through about two of 30 cells of a column.
  EXPECT_LT(visited(points, 0, 899).size(), 200u);
  EXPECT_LT(visited(points, 0, 29).size(), 100u) << "up";
  EXPECT_LT(visited(points, 0, 870).size(), 100u) << "across";
}

TEST(PointGrid, visits_all_on_a_segment_where_points_crowd_together) {
  Random random(10);
  for (int k = 0; k < 20; ++k) {
    Points points;
    for (int x = 0; x < 12; ++x)
      for (int y = 0; y < 12; ++y)
        if (!one_in(random, 4)) points.add(x, y);
    points.add(100 * uniform(random, 1, 1000), uniform(random, -9, 9));
    points.add(uniform(random, -9, 9), -1'000'000'000);
    points.add(1'000'000'000, 1'000'000'000);
    expect_complete(points);
  }
}

TEST(PointGrid, does_not_visit_a_crowd_for_each_of_its_points) {
  // A comb and points far away, each ten thousand times as far as the one before.
  Points points;
  for (int x = 0; x < 2000; ++x) points.add(x, x % 2);
  for (const int far : {20'000'000, 2'000'000'000}) points.add(far, far);
  std::size_t most = 0;
  for (std::uint32_t x = 0; x + 2 < 2000; ++x)
    most = std::max(most, visited(points, x, x + 2).size());
  EXPECT_LT(most, 300u);
  EXPECT_LT(visited(points, 0, 2001).size(), 300u) << "through the crowd's corner";
}

}  // namespace
}  // namespace oplus::slide
