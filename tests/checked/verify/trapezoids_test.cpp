// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/trapezoids.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/families/family.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

bool contains(const Trapezoid& t, const std::vector<Segment>& edges, const Point& x) {
  return edges[t.left].source.x < x.x && x.x < edges[t.right].source.x &&
         orientation(edges[t.below].source, edges[t.below].target, x) > 0 &&
         orientation(edges[t.above].source, edges[t.above].target, x) > 0;
}

/// With holes, components, and chains that touch.
TEST(Trapezoids, a_point_of_the_region_is_in_one_and_other_points_in_none) {
  std::size_t inside = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
      const Region region = generate(family, family.smallest + 2, seed).p;
      const std::vector<Segment> all = edges(region);
      const std::vector<Trapezoid> parts = trapezoids(region);
      EXPECT_LE(parts.size(), 2 * all.size()) << family.name;
      for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 20) {
        for (std::size_t j = 0; j < all.size(); j += 1 + all.size() / 20) {
          // On no wall and no edge, mostly.
          const Point x =
              Rational(1, 7) * (Rational(3) * all[i].source + Rational(4) * all[j].target) +
              Point{Rational(1, 1013), Rational(1, 1009)};
          if (locate(x, region) == Location::boundary) continue;
          const bool is_on_wall = std::any_of(all.begin(), all.end(),
                                              [&](const Segment& e) { return e.source.x == x.x; });
          if (is_on_wall) continue;
          const auto count = std::count_if(parts.begin(), parts.end(),
                                           [&](const Trapezoid& t) { return contains(t, all, x); });
          const bool is_inside = locate(x, region) == Location::inside;
          EXPECT_EQ(count, is_inside ? 1 : 0) << family.name << " " << seed << ", " << to_string(x);
          inside += is_inside;
        }
      }
    }
  }
  EXPECT_GT(inside, 1000U);
}

}  // namespace
}  // namespace oplus
