// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/convex_cover.hpp"

#include <gtest/gtest.h>

#include "checked/engines/engines.hpp"
#include "checked/slide/slide.hpp"
#include "reference/families/family.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// A staircase of short steps, on a box.
Region staircase(int steps) {
  Chain chain{{0, -steps}, {steps, -steps}};
  for (int i = steps; i-- > 0;) {
    chain.push_back({i + 1, steps - 1 - i});
    chain.push_back({i, steps - 1 - i});
  }
  chain.back() = {0, steps - 1};
  return polygon(std::move(chain));
}

const Region hexagon = polygon({{0, 0}, {12, -4}, {20, 4}, {20, 12}, {8, 16}, {0, 8}});

/// On a coast, most boxes that can have such a vertex have none: the search must be long enough to find it.
TEST(ConvexCover, finds_nearly_all_that_is_inside_a_coast_of_short_edges) {
  const Region coast = generate(*find_family("coast"), 50'000, 1).p;
  const Region disc = generate(*find_family("convex"), 20, 1).q;
  const Statistics found = slide_sum(coast, disc, Boundary::closed).statistics;
  EXPECT_LT(10 * found.count("probes"), found.count("segments slid along"));
}

TEST(ConvexCover, changes_no_sum) {
  const Engine& rca = *find_engine(engines(), "rca");
  std::size_t features = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const auto& [p, q] : {std::pair("pockets", "pockets"), std::pair("tight", "convex"),
                               std::pair("grid", "convex"), std::pair("convex", "comb")}) {
      const Region of_p = generate(*find_family(p), 60, seed).p;
      const Region of_q = generate(*find_family(q), 60, seed).q;
      for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
        const PlanarSet found = slide_sum(of_p, of_q, boundary).sum;
        EXPECT_TRUE(found == rca.compute(of_p, of_q, boundary, {}).sum) << p << ' ' << q << seed;
        features += found.dangling_edges.size() + found.isolated_vertices.size();
      }
    }
  }
  EXPECT_GT(features, 0u);
}

TEST(ConvexCover, is_of_one_summand_that_is_convex_and_has_few_edges) {
  const auto is_used = [](const Region& p, const Region& q) {
    return slide_sum(p, q, Boundary::closed)
               .statistics.count("segments inside a convex summand, moved") > 0;
  };
  EXPECT_TRUE(is_used(staircase(100), hexagon));
  EXPECT_TRUE(is_used(hexagon, staircase(100)));
  EXPECT_FALSE(is_used(staircase(100), staircase(20)));
  Region with_hole = hexagon;
  with_hole.components[0].holes.push_back(backwards(box(8, 4, 10, 6)));
  EXPECT_FALSE(is_used(staircase(100), with_hole));
}

}  // namespace
}  // namespace oplus
