// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/inner_fit_in_convex.hpp"

#include <gtest/gtest.h>

#include "checked/operations/complement.hpp"
#include "checked/operations/image.hpp"
#include "checked/operations/operations.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/statements/laws/convex_hull.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/families/family.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

std::vector<Point> vertices(const Region& region) {
  std::vector<Point> all;
  each_vertex(region, [&](const Point& v) { all.push_back(v); });
  return all;
}

/// As for any P.
PlanarSet general(const Region& p, const Region& q) {
  return complement(no_fit(complement(p), q, by_slide));
}

Region scaled(const Region& region, const Rational& x, const Rational& y) {
  return mapped(region, [&](const Point& v) { return Point{x * v.x, y * v.y}; });
}

TEST(InnerFitInConvex, is_that_of_any_region) {
  std::size_t empty = 0, points = 0, segments = 0, polygons = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      const auto [p, q] = generate(family, family.smallest + 1, seed);
      if (vertex_count(p) * vertex_count(q) > 400) continue;
      const Chain hull = convex_hull(chains(p));
      const Region around = polygon(hull);
      // Wide enough, just wide enough, and wide enough to the left only.
      const Region containers[] = {around,
                                   scaled(around, Rational(9, 2), 3),
                                   scaled(around, 1, 5),
                                   scaled(around, Rational(7, 3), 1),
                                   {{{convex_hull(chains(q)), {}}}}};
      for (const Region& container : containers) {
        for (const Region* part : {&p, &q}) {
          const std::optional<PlanarSet> fit =
              inner_fit_in_convex(container.components[0].outer, vertices(*part));
          ASSERT_TRUE(fit.has_value());
          const PlanarSet expected = general(container, *part);
          ASSERT_EQ(*fit, expected) << family.name << ' ' << seed;
          EXPECT_EQ(inner_fit(container, *part, by_slide), expected);
          EXPECT_EQ(operation_called("ifp").compute_of_sets(canonical_sum(container),
                                                            canonical_sum(*part), by_slide),
                    expected);
          empty += expected == PlanarSet{};
          points += !expected.isolated_vertices.empty();
          segments += !expected.dangling_edges.empty();
          polygons += !expected.outer.empty();
        }
      }
    }
  }
  EXPECT_GT(empty, 50U);
  EXPECT_GT(points, 50U);
  EXPECT_GT(segments, 50U);
  EXPECT_GT(polygons, 50U);
}

TEST(InnerFitInConvex, is_of_a_convex_chain_only) {
  EXPECT_FALSE(inner_fit_in_convex({{0, 0}, {4, 0}, {4, 4}, {3, 1}}, {{0, 0}}).has_value());
  const Chain with_vertex_inside_an_edge{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(inner_fit_in_convex(with_vertex_inside_an_edge, {{0, 0}, {1, 1}}),
            canonical_sum(polygon(box(0, 0, 3, 3))));
}

}  // namespace
}  // namespace oplus
