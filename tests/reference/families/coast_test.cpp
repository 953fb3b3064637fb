// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/coast.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/definitions/validity.hpp"

namespace oplus {
namespace {

Chain coast_chain(std::uint64_t seed, std::size_t n) {
  Random random(seed);
  return coast_polygon(random, n).components.at(0).outer;
}

std::size_t reflex_vertices(const Chain& chain) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t j = next(i, chain.size());
    if (orientation(chain[i], chain[j], chain[next(j, chain.size())]) < 0) ++count;
  }
  return count;
}

TEST(Coast, is_simple_counterclockwise_and_has_n_vertices) {
  for (const std::size_t n : {3, 4, 5, 6, 10, 50, 1000}) {
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
  for (const Point& p : coast_chain(1, 1000)) {
    for (const Rational& c : {p.x, p.y}) {
      EXPECT_EQ(c.get_den(), 1);
      EXPECT_GE(c, 0);
      EXPECT_LE(c, 1 << 20);
    }
  }
}

TEST(Coast, has_bays) { EXPECT_GT(reflex_vertices(coast_chain(1, 1000)), 300u); }

TEST(Coast, is_the_same_for_the_same_seed) {
  EXPECT_EQ(coast_chain(7, 100), coast_chain(7, 100));
  EXPECT_NE(coast_chain(7, 100), coast_chain(8, 100));
}

}  // namespace
}  // namespace oplus
