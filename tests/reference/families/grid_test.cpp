// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/families/family.hpp"

namespace oplus {
namespace {

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

}  // namespace
}  // namespace oplus
