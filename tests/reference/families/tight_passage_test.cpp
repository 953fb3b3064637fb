// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference/families/family.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {
namespace {

TEST(TightFamily, half_of_the_open_sums_have_a_low_dimensional_feature) {
  const Family& family = *find_family("tight");
  constexpr int cases = 100;
  int with_dangling_edges = 0;
  int with_isolated_vertices = 0;
  int with_either = 0;
  int closed_holes = 0;
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const Summands summands = generate(family, family.typical, seed);
    const OracleSums sums = oracle_sums(summands.p, summands.q);
    const bool dangling = !sums.open.dangling_edges.empty();
    const bool isolated = !sums.open.isolated_vertices.empty();
    with_dangling_edges += dangling ? 1 : 0;
    with_isolated_vertices += isolated ? 1 : 0;
    with_either += dangling || isolated ? 1 : 0;
    closed_holes += sums.closed.holes.empty() ? 0 : 1;
  }
  EXPECT_GE(with_either, cases / 2);
  EXPECT_GE(with_dangling_edges, cases / 5);
  EXPECT_GE(with_isolated_vertices, cases / 5);
  // And some do not fit, or have room.
  EXPECT_LT(with_either, cases);
  EXPECT_GE(closed_holes, 1);
}

}  // namespace
}  // namespace oplus
