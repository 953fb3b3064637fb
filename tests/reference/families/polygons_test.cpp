// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/polygons.hpp"

#include <gtest/gtest.h>

#include "reference/chains/validity.hpp"

namespace oplus {
namespace {

bool is_strictly_convex(const Chain& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t j = next(i, chain.size());
    if (orientation(chain[i], chain[j], chain[next(j, chain.size())]) <= 0) return false;
  }
  return true;
}

struct Row {
  const char* name;
  Region (*make)(Random& random, std::size_t n);
  bool is_convex;
  int least, most;  ///< of the coordinates
};

constexpr int million = 1'000'000;

/// Families are compared at one size (family_test); benchmarks want all sizes.
TEST(Polygons, have_n_vertices_with_integer_coordinates_of_their_range) {
  for (const Row& row : {Row{"convex", convex_polygon, true, -million, million},
                         {"star", star_polygon, false, -million, million},
                         {"simple", simple_polygon, false, 0, million},
                         {"coast", coast_polygon, false, 0, 1 << 20}}) {
    Random random(1);
    for (const std::size_t n : {3U, 4U, 5U, 8U, 20U, 300U, 1000U}) {
      SCOPED_TRACE(row.name + std::to_string(n));
      const Region region = row.make(random, n);
      ASSERT_EQ(chains(region).size(), 1U);
      const Chain& chain = region.components[0].outer;
      EXPECT_EQ(chain.size(), n);
      EXPECT_EQ(find_defect(region), std::nullopt);
      EXPECT_GT(area(region), 0);
      if (row.is_convex || n > 8) {
        EXPECT_EQ(is_strictly_convex(chain), row.is_convex);
      }
      for (const Point& p : chain)
        for (const Rational& c : {p.x, p.y})
          EXPECT_TRUE(c.get_den() == 1 && row.least <= c && c <= row.most) << c;
    }
  }
}

TEST(ConvexPolygon, grows_where_the_grid_would_be_too_coarse) {
  Random random(1);
  const Region region = convex_polygon(random, 3000);
  EXPECT_EQ(vertex_count(region), 3000u);
  EXPECT_TRUE(is_strictly_convex(region.components[0].outer));
}

}  // namespace
}  // namespace oplus
