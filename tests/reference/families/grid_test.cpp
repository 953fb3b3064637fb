// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "properties/runner/classification.hpp"
#include "reference/families/family.hpp"

namespace oplus {
namespace {

TEST(GridFamily, is_degenerate_all_the_time) {
  const Family& family = *find_family("grid");
  std::map<std::string, int> count;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    for (const auto& [name, value] : named(classify(generate(family, 8, seed))))
      count[name] += value ? 1 : 0;
  }
  EXPECT_GE(count["parallel edges"], 340);
  EXPECT_GE(count["collinear vertices"], 200);
  EXPECT_GE(count["reflex vertices"], 140);
  EXPECT_GE(count["overlapping segments"], 40);
  EXPECT_EQ(count["holes"], 0);
  EXPECT_EQ(count["several components"], 0);
}

TEST(GridFamily, stays_within_n_vertices_and_small_grids) {
  const Family& family = *find_family("grid");
  for (std::size_t n = 3; n <= 8; ++n) {
    std::size_t most = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const Summands summands = generate(family, n, seed);
      for (const Region* region : {&summands.p, &summands.q}) {
        most = std::max(most, vertex_count(*region));
        for (const Point& p : region->components[0].outer) {
          EXPECT_LE(abs(p.x), 6);
          EXPECT_LE(abs(p.y), 6);
        }
      }
    }
    EXPECT_EQ(most, n);
  }
}

TEST(GridFamily, has_sums_and_differences_of_a_polygon_with_itself) {
  const Family& family = *find_family("grid");
  int same = 0;
  int turned = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Summands summands = generate(family, 8, seed);
    same += summands.p == summands.q ? 1 : 0;
    turned += summands.p == reflected(summands.q) ? 1 : 0;
  }
  EXPECT_GE(same, 4);
  EXPECT_GE(turned, 4);
}

}  // namespace
}  // namespace oplus
