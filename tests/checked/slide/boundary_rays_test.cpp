// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/boundary_rays.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "reference/chains/touching_points.hpp"
#include "reference/families/family.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus::slide {
namespace {

Region region(const char* text) { return region_from(text).region; }

using Numbers = SmallNumbers;

struct Prepared {
  explicit Prepared(const Region& region)
      : both(region, region, scaling_of(region, region), 0), rays(both.p, both.tree_of_p) {}

  Point vertex(std::uint32_t number) const {
    const auto& v = both.p.edges[number].source;
    return {Rational(v.x), Rational(v.y)};
  }
  std::size_t ray_count(const Feature& feature) const {
    std::size_t count = 0;
    rays.each_ray(feature, [&](const Ray<Numbers>&) { ++count; });
    return count;
  }

  IntegerSummands<Numbers> both;
  BoundaryRays<Numbers> rays;
};

TEST(BoundaryRays, are_those_of_all_chains_that_touch) {
  const Prepared square(region("POLYGON((0 0,4 0,4 4,0 4,0 0),(0 2,2 4,4 0,0 2))"));
  for (std::uint32_t i = 0; i < square.both.p.edges.size(); ++i) {
    const Point v = square.vertex(i);
    const bool touches = v == Point{0, 2} || v == Point{2, 4} || v == Point{4, 0};
    EXPECT_EQ(square.ray_count({i, true}), touches ? 4u : 2u) << testing::PrintToString(v);
    EXPECT_EQ(square.ray_count({i, false}), 2u);
    EXPECT_EQ(square.rays.is_touching_point({i, true}), touches);
    EXPECT_FALSE(square.rays.is_touching_point({i, false}));
  }
  EXPECT_TRUE(square.rays.has_inside());
  // The sides from (4, 4) to (0, 4) and from there to (0, 0).
  ASSERT_EQ(square.rays.inside(2).size(), 1u);
  EXPECT_EQ(square.vertex(square.rays.inside(2)[0].second), (Point{2, 4}));
  EXPECT_EQ(square.rays.inside(3).size(), 1u);
  EXPECT_TRUE(square.rays.inside(0).empty());
}

TEST(BoundaryRays, lead_ahead_and_back) {
  const Prepared square(region("POLYGON((0 0,4 0,4 4,0 4,0 0))"));
  std::vector<Ray<Numbers>> rays;
  square.rays.each_ray({1, true}, [&](const Ray<Numbers>& ray) { rays.push_back(ray); });
  ASSERT_EQ(rays.size(), 2u);
  EXPECT_EQ(rays[0].direction.y, 4);
  EXPECT_TRUE(rays[0].interior_is_counterclockwise);
  EXPECT_EQ(rays[1].direction.x, -4);
  EXPECT_FALSE(rays[1].interior_is_counterclockwise);
  EXPECT_EQ(square.rays.target(3), 0u);
}

TEST(BoundaryRays, find_the_touching_points_of_a_region) {
  std::size_t touching = 0;
  for (const char* name : {"tight", "holes", "islands"}) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const Region p = generate(*find_family(name), 6, seed).p;
      if (!scaling_of(p, p).is_trivial()) continue;
      const Prepared prepared(p);
      std::set<Point> found;
      for (const std::uint32_t v : prepared.rays.touching_points())
        EXPECT_TRUE(found.insert(prepared.vertex(v)).second) << "named twice";
      const std::vector<Point> expected = touching_points(p);
      EXPECT_EQ(found, std::set<Point>(expected.begin(), expected.end()));
      touching += found.size();
    }
  }
  EXPECT_GT(touching, 20u);
}

}  // namespace
}  // namespace oplus::slide
