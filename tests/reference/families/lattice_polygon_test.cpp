// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/lattice_polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reference/chains/validity.hpp"

namespace oplus {
namespace {

bool is_simple(const Chain& chain) {
  return sign(twice_area(chain)) > 0 && !find_defect(polygon(chain));
}

/// The same polygon from its smallest vertex on.
Chain from_smallest(Chain chain) {
  std::rotate(chain.begin(), std::min_element(chain.begin(), chain.end()), chain.end());
  return chain;
}

/// Adds all simple counterclockwise polygons on the points that begin like the chain.
void extend(const Chain& chain, const Chain& points, std::size_t most, std::set<Chain>& all) {
  if (chain.size() >= 3 && is_simple(chain)) all.insert(chain);
  if (chain.size() == most) return;
  for (const Point& p : points) {
    if (p <= chain.front() || std::find(chain.begin(), chain.end(), p) != chain.end()) continue;
    Chain longer = chain;
    longer.push_back(p);
    extend(longer, points, most, all);
  }
}

TEST(LatticePolygon, reaches_every_simple_polygon_of_the_grid) {
  Chain points;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y) points.push_back({x, y});
  std::set<Chain> all;
  for (const Point& p : points) extend({p}, points, 5, all);
  // 76 triangles: 84 triples less 8 lines.
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Chain& c) { return c.size() == 3; }),
            76);
  Random random(1);
  std::set<Chain> drawn;
  for (int i = 0; i < 60000; ++i) drawn.insert(from_smallest(lattice_polygon(random, 3, 5)));
  EXPECT_EQ(drawn, all);
}

TEST(LatticePolygon, is_simple_and_within_its_bounds) {
  Random random(2);
  std::set<std::size_t> counts;
  for (int i = 0; i < 2000; ++i) {
    const int side = uniform(random, 3, 7);
    const Chain chain = lattice_polygon(random, side, 8);
    ASSERT_TRUE(is_simple(chain));
    counts.insert(chain.size());
    for (const Point& p : chain) {
      EXPECT_TRUE(p.x >= 0 && p.x < side && p.y >= 0 && p.y < side);
    }
  }
  EXPECT_EQ(counts, (std::set<std::size_t>{3, 4, 5, 6, 7, 8}));
}

TEST(PolygonThrough, uses_every_point_and_no_other) {
  Random random(3);
  const std::vector<LatticePoint> points{{0, 0}, {3, 1}, {1, 2}, {4, 4}, {0, 3}, {2, 0}};
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const std::optional<Chain> chain = polygon_through(random, points);
    if (!chain) continue;
    ++found;
    EXPECT_TRUE(is_simple(*chain));
    EXPECT_EQ(chain->size(), points.size());
    for (const LatticePoint& p : points)
      EXPECT_NE(std::find(chain->begin(), chain->end(), (Point{p.x, p.y})), chain->end());
  }
  EXPECT_GE(found, 90);
}

TEST(PolygonThrough, finds_none_on_a_line) {
  Random random(4);
  EXPECT_EQ(polygon_through(random, {{0, 0}, {1, 1}, {2, 2}, {3, 3}}), std::nullopt);
  EXPECT_EQ(polygon_through(random, {{0, 0}, {5, 0}, {2, 0}}), std::nullopt);
}

TEST(LatticePolygonWithin, keeps_its_vertices_inside_or_on_the_chain) {
  Random random(5);
  const Chain around{{0, 0}, {6, 0}, {6, 6}, {3, 2}, {0, 6}};
  const Chain clockwise(around.rbegin(), around.rend());
  int found = 0;
  int touching = 0;
  for (int i = 0; i < 200; ++i) {
    const auto chain = lattice_polygon_within(random, i % 2 == 0 ? around : clockwise, 6);
    if (!chain) continue;
    ++found;
    EXPECT_TRUE(is_simple(*chain));
    bool touches = false;
    for (const Point& p : *chain) {
      const Location where = locate(p, polygon(around));
      EXPECT_NE(where, Location::outside);
      touches = touches || where == Location::boundary;
    }
    touching += touches ? 1 : 0;
  }
  EXPECT_GE(found, 150);
  EXPECT_GE(touching, 100);
}

}  // namespace
}  // namespace oplus
