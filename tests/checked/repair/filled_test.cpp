// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/repair/filled.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/region.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/families/random.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// Chains with repeated vertices, spikes, overlaps, and whatever else few grid points make.
std::vector<Chain> random_chains(Random& random) {
  std::vector<Chain> chains(uniform_index(random, 3) + 1);
  for (Chain& chain : chains) {
    chain.resize(uniform_index(random, 8));
    for (Point& p : chain) {
      p.x = uniform(random, 0, 4);
      p.y = uniform(random, 0, 4);
    }
  }
  return chains;
}

TEST(Filled, has_the_points_of_the_rule_inside) {
  Random random(20);
  int inside = 0, outside = 0, different = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Chain> chains = random_chains(random);
    std::vector<Segment> segments;
    for (const Chain& chain : chains)
      for (const Segment& e : edges(chain)) segments.push_back(e);
    const Region even_odd = region_of(filled(chains, FillRule::even_odd));
    const Region nonzero = region_of(filled(chains, FillRule::nonzero));
    EXPECT_FALSE(find_defect(even_odd));
    EXPECT_FALSE(find_defect(nonzero));
    for (int x = 0; x < 12; ++x) {
      const Point p{Rational(3 * x + 1, 9) + Rational(1, 101),
                    Rational(uniform(random, 0, 40), 10) + Rational(1, 103)};
      if (lies_on_one(p, segments)) continue;
      const int winding = winding_number(p, segments);
      const auto location = [](bool is_inside) {
        return is_inside ? Location::inside : Location::outside;
      };
      EXPECT_EQ(locate(p, even_odd), location(winding % 2 != 0));
      EXPECT_EQ(locate(p, nonzero), location(winding != 0));
      ++(winding != 0 ? inside : outside);
      different += winding != 0 && winding % 2 == 0;
    }
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 300);
  EXPECT_GT(different, 10);
}

}  // namespace
}  // namespace oplus
