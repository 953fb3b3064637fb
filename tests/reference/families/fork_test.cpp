// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/fork.hpp"

#include <gtest/gtest.h>

#include "reference/chains/validity.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {
namespace {

TEST(ForkAndL, has_teeth_on_both_arms) {
  for (const std::size_t teeth : {1u, 2u, 3u, 10u, 50u}) {
    const Summands summands = fork_and_l(teeth);
    EXPECT_EQ(vertex_count(summands.p), 8 * teeth + 4);
    EXPECT_EQ(vertex_count(summands.q), 6u);
    EXPECT_EQ(find_defect(summands.p), std::nullopt);
    EXPECT_EQ(find_defect(summands.q), std::nullopt);
  }
}

TEST(ForkAndL, sum_has_n_squared_holes) {
  for (const std::size_t teeth : {1u, 2u, 3u}) {
    const Summands summands = fork_and_l(teeth);
    const MinkowskiSum sum = oracle_sum(summands.p, summands.q, Boundary::closed);
    EXPECT_EQ(sum.outer.size(), 1u);
    EXPECT_EQ(sum.holes.size(), teeth * teeth);
  }
}

TEST(ForkFamily, random_teeth_leave_as_many_holes) {
  const Family& family = *find_family("fork");
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Summands summands = generate(family, 2, seed);
    EXPECT_EQ(oracle_sum(summands.p, summands.q, Boundary::closed).holes.size(), 4u) << seed;
  }
}

}  // namespace
}  // namespace oplus
