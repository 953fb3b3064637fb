// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/chains/validity.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/families/family.hpp"

namespace oplus {
namespace {

constexpr std::size_t sizes[] = {3, 4, 5, 6, 7, 8, 20, 100, 300};

bool within(const Region& region, const Rational& low, const Rational& high) {
  for (const Point& p : region.components[0].outer)
    if (p.x < low || p.x > high || p.y < low || p.y > high) return false;
  return true;
}

bool on_integers(const Region& region) {
  for (const Point& p : region.components[0].outer)
    if (p.x.get_den() != 1 || p.y.get_den() != 1) return false;
  return true;
}

void expect_one_chain_of(std::size_t n, const Region& region) {
  ASSERT_EQ(region.components.size(), 1u);
  EXPECT_TRUE(region.components[0].holes.empty());
  EXPECT_EQ(region.components[0].outer.size(), n);
  EXPECT_EQ(find_defect(region), std::nullopt);
  EXPECT_GT(area(region), 0);
  EXPECT_TRUE(on_integers(region));
}

bool strictly_convex(const Chain& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t j = next(i, chain.size());
    if (orientation(chain[i], chain[j], chain[next(j, chain.size())]) <= 0) return false;
  }
  return true;
}

TEST(ConvexPolygon, has_n_vertices_and_is_strictly_convex) {
  Random random(1);
  for (const std::size_t n : sizes) {
    const Region region = convex_polygon(random, n);
    expect_one_chain_of(n, region);
    EXPECT_TRUE(strictly_convex(region.components[0].outer)) << n;
    EXPECT_TRUE(within(region, -1'000'000, 1'000'000)) << n;
  }
}

TEST(ConvexPolygon, grows_where_the_grid_would_be_too_coarse) {
  Random random(1);
  const Region region = convex_polygon(random, 3000);
  EXPECT_EQ(vertex_count(region), 3000u);
  EXPECT_TRUE(strictly_convex(region.components[0].outer));
  EXPECT_FALSE(within(region, -1'000'000, 1'000'000));
}

TEST(StarPolygon, has_n_vertices_all_seen_from_the_origin) {
  Random random(1);
  for (const std::size_t n : sizes) {
    const Region region = star_polygon(random, n);
    expect_one_chain_of(n, region);
    for (const Segment& e : edges(region)) EXPECT_GT(cross(e.source, e.target), 0) << n;
    EXPECT_TRUE(within(region, -1'000'000, 1'000'000)) << n;
  }
}

TEST(SimplePolygon, has_n_vertices) {
  Random random(1);
  for (const std::size_t n : sizes) {
    const Region region = simple_polygon(random, n);
    expect_one_chain_of(n, region);
    EXPECT_TRUE(within(region, 0, 1'000'000)) << n;
  }
}

TEST(SimplePolygon, is_not_convex) {
  Random random(1);
  int not_convex = 0;
  for (int i = 0; i < 50; ++i)
    not_convex += strictly_convex(simple_polygon(random, 12).components[0].outer) ? 0 : 1;
  EXPECT_EQ(not_convex, 50);
}

TEST(CoastPolygon, has_n_vertices) {
  for (const std::size_t n : {3, 4, 5, 6, 10, 50, 1000}) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      SCOPED_TRACE(std::to_string(n) + " vertices, seed " + std::to_string(seed));
      Random random(seed);
      const Region region = coast_polygon(random, n);
      expect_one_chain_of(n, region);
      EXPECT_TRUE(within(region, 0, 1 << 20));
    }
  }
}

TEST(CoastPolygon, has_bays) {
  Random random(1);
  EXPECT_GT(reflex_vertices(coast_polygon(random, 1000), {}).size(), 300u);
}

TEST(CoastPolygon, is_the_same_for_the_same_seed) {
  const auto coast = [](std::uint64_t seed) {
    Random random(seed);
    return coast_polygon(random, 100);
  };
  EXPECT_EQ(coast(7), coast(7));
  EXPECT_NE(coast(7), coast(8));
}

TEST(ConvexGridPolygon, is_strictly_convex_on_its_grid) {
  Random random(1);
  std::size_t most = 0;
  for (int i = 0; i < 200; ++i) {
    const Region region = convex_grid_polygon(random, 8, 5);
    EXPECT_EQ(find_defect(region), std::nullopt);
    EXPECT_TRUE(strictly_convex(region.components[0].outer));
    EXPECT_TRUE(within(region, 0, 4));
    most = std::max(most, vertex_count(region));
  }
  EXPECT_GE(most, 6u);
  EXPECT_LE(most, 8u);
}

TEST(ThesisFamilies, both_summands_have_n_vertices) {
  for (const char* name : {"convex", "star", "simple"}) {
    const Family& family = *find_family(name);
    for (const std::size_t n : {3u, 8u, 40u}) {
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Summands summands = generate(family, n, seed);
        EXPECT_EQ(vertex_count(summands.p), n) << name;
        EXPECT_EQ(vertex_count(summands.q), n) << name;
        EXPECT_NE(summands.p, summands.q) << name;
      }
    }
  }
}

}  // namespace
}  // namespace oplus
