// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/pair_table.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <vector>

#include "reference/families/random.hpp"

namespace oplus::slide {
namespace {

struct Edge {
  std::int64_t x, y, dx, dy;

  NearSegment near() const {
    const auto rounded = [](std::int64_t value) { return static_cast<double>(value); };
    return {rounded(x), rounded(y), rounded(dx), rounded(dy)};
  }
};

using Edges = std::vector<Edge>;

Edge random_edge(Random& random, int size) {
  const auto number = [&] { return uniform(random, -size, size); };
  const std::int64_t x = number(), y = number(), dx = number(), dy = number();
  return {x, y, dx, dy};
}

Edges random_edges(Random& random, std::size_t count, int size) {
  Edges edges;
  while (edges.size() < count) edges.push_back(random_edge(random, size));
  return edges;
}

std::vector<NearSegment> near(const Edges& edges) {
  std::vector<NearSegment> result;
  for (const Edge& e : edges) result.push_back(e.near());
  return result;
}

/// Whether the segment is nearer than the margins to both strips, in integers.
bool is_near(const Edge& s, const Edge& e, const Edge& f, std::int64_t across, std::int64_t along) {
  const std::int64_t x = 2 * (s.x - e.x - f.x) + s.dx - e.dx - f.dx;
  const std::int64_t y = 2 * (s.y - e.y - f.y) + s.dy - e.dy - f.dy;
  const std::int64_t area = std::abs(e.dx * f.dy - e.dy * f.dx);
  const auto is_near_strip = [&](const Edge& side) {
    const std::int64_t slope = s.dx * side.dy - s.dy * side.dx;
    return std::abs(x * side.dy - y * side.dx) <
           area + (slope == 0 ? along : std::abs(slope) + across);
  };
  return is_near_strip(e) && is_near_strip(f);
}

TEST(PairTable, visits_the_pairs_whose_strips_are_near_both_once_each) {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  Random random(28);
  std::size_t visited = 0, all = 0;
  for (const auto& [n, m] : std::vector<std::pair<std::size_t, std::size_t>>{{1, 1},
                                                                             {3, 4},
                                                                             {4, 3},
                                                                             {5, 5},
                                                                             {10, 10},
                                                                             {11, 9},
                                                                             {2, 190},
                                                                             {256, 2},
                                                                             {3, 170},
                                                                             {22, 23}})
    for (int i = 0; i < 40; ++i) {
      const int size = uniform(random, 3, 60);
      const Edges of_p = random_edges(random, n, size), of_q = random_edges(random, m, size);
      const PairTable table(near(of_p), near(of_q), 512);
      ASSERT_FALSE(table.is_empty());
      const Edge segment = random_edge(random, size);
      const std::int64_t across = uniform(random, 0, 2), along = uniform(random, 0, 2);
      std::set<Pair> found, expected;
      table.each_near(segment.near(), {static_cast<double>(across), static_cast<double>(along)},
                      [&](const Pair& pair) { ASSERT_TRUE(found.insert(pair).second); });
      for (std::uint32_t e = 0; e < n; ++e)
        for (std::uint32_t f = 0; f < m; ++f)
          if (is_near(segment, of_p[e], of_q[f], across, along)) expected.insert({e, f});
      ASSERT_EQ(found, expected) << n << " and " << m;
      visited += found.size();
      all += n * m;
    }
  EXPECT_GT(visited, all / 20);
  EXPECT_LT(visited, all * 19 / 20);
}

TEST(PairTable, is_empty_where_there_are_too_many_pairs) {
  const std::vector<NearSegment> few(3, {0, 0, 1, 1}), many(300, {0, 0, 1, 1});
  EXPECT_TRUE(PairTable(few, few, 8).is_empty());
  EXPECT_FALSE(PairTable(few, few, 9).is_empty());
  EXPECT_TRUE(PairTable(many, few, 10000).is_empty());
  EXPECT_TRUE(PairTable(few, many, 10000).is_empty());
}

}  // namespace
}  // namespace oplus::slide
