// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/generators/coast.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/definitions/validity.hpp"

namespace oplus {
namespace {

const Chain& chain_of(const Region& region) { return region.components.at(0).outer; }

std::size_t reflex_vertices(const Chain& chain) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t j = next(i, chain.size());
    if (orientation(chain[i], chain[j], chain[next(j, chain.size())]) < 0) ++count;
  }
  return count;
}

TEST(Coast, is_simple_counterclockwise_and_has_n_vertices) {
  for (const std::size_t n : {3, 4, 5, 6, 10, 50, 300}) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      Random random(seed);
      const Region region = coast_polygon(random, n);
      EXPECT_EQ(region.components.size(), 1u);
      EXPECT_EQ(vertex_count(region), n);
      EXPECT_EQ(find_defect(region), std::nullopt) << n << " vertices, seed " << seed;
      EXPECT_GT(area(region), 0);
    }
  }
}

TEST(Coast, is_on_integers_from_0_to_a_power_of_two) {
  Random random(1);
  for (const Point& p : chain_of(coast_polygon(random, 1000))) {
    for (const Rational& c : {p.x, p.y}) {
      EXPECT_EQ(c.get_den(), 1);
      EXPECT_GE(c, 0);
      EXPECT_LE(c, 1 << 20);
    }
  }
}

TEST(Coast, has_bays) {
  Random random(1);
  EXPECT_GT(reflex_vertices(chain_of(coast_polygon(random, 1000))), 300u);
}

TEST(Coast, is_the_same_for_the_same_seed) {
  Random first(7);
  Random second(7);
  Random third(8);
  const Region coast = coast_polygon(first, 100);
  EXPECT_EQ(coast, coast_polygon(second, 100));
  EXPECT_NE(coast, coast_polygon(third, 100));
}

}  // namespace
}  // namespace oplus
