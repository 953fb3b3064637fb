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

TEST(PointGrid, visits_all_on_a_segment_where_points_are_in_line_or_equal_in_doubles) {
  for (const int step : {0, 1}) {
    Points points;
    for (int k = 0; k < 70; ++k) points.add(7, step * k);
    expect_complete(points);
  }
}

TEST(PointGrid, does_not_visit_a_crowd_in_a_cell_that_a_segment_passes_elsewhere) {
  Points points;
  for (const int c : {510, 590}) {
    for (const int far : {0, 1000}) {
      points.add(c, far);
      points.add(far, c);
    }
  }
  for (int x = 540; x < 549; ++x)
    for (int y = 540; y < 549; ++y) points.add(x, y);
  for (const std::uint32_t from : {0U, 1U, 4U, 5U})
    EXPECT_LE(visited(points, from, from + 2).size(), 8U) << "all but the crowd";
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
