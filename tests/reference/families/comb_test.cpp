// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference/definitions/original_convolution.hpp"
#include "reference/families/family.hpp"

namespace oplus {
namespace {

TEST(CombFamily, has_n_teeth_and_a_convex_polygon) {
  const Family& family = *find_family("comb");
  for (const std::size_t teeth : {1u, 2u, 4u, 25u}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Summands summands = generate(family, teeth, seed);
      EXPECT_EQ(vertex_count(summands.p), 2 * teeth + 3);
      // Between two teeth there is a reflex vertex; the first and the last valley may be convex.
      const std::size_t reflex = reflex_vertices(summands.p, {}).size();
      EXPECT_GE(reflex, teeth - 1);
      EXPECT_LE(reflex, teeth + 1);
      EXPECT_TRUE(reflex_vertices({}, summands.q).empty());
      EXPECT_LE(vertex_count(summands.q), 8u);
    }
  }
}

}  // namespace
}  // namespace oplus
