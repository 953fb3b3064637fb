// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/diamond_and_u.hpp"

#include <gtest/gtest.h>

#include "reference/chains/validity.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {
namespace {

OracleSums sums_of(const Rational& eps1, const Rational& eps2) {
  const Summands summands = diamond_and_u(eps1, eps2);
  EXPECT_EQ(find_defect(summands.p), std::nullopt);
  EXPECT_EQ(find_defect(summands.q), std::nullopt);
  return oracle_sums(summands.p, summands.q);
}

TEST(DiamondAndU, unperturbed_has_a_hole_and_a_dangling_edge) {
  const OracleSums sums = sums_of(0, 0);
  EXPECT_EQ(sums.closed.holes.size(), 1u);
  EXPECT_EQ(sums.open.holes.size(), 1u);
  EXPECT_EQ(sums.open.dangling_edges.size(), 1u);
}

TEST(DiamondAndU, perturbed_the_diamond_enters_but_does_not_pass) {
  const Rational eps1(1, 1'000'000'000);
  const Rational eps2 = eps1 / 3;
  const MinkowskiSum with_hole = sums_of(eps1, eps2).open;
  EXPECT_EQ(with_hole.holes.size(), 1u);
  EXPECT_TRUE(with_hole.dangling_edges.empty());
  // The thesis's two edges bound a thin wedge, which the sum has not where the hatch is too narrow
  // from the top on.
  const MinkowskiSum blocked = sums_of(0, eps2).open;
  EXPECT_EQ(blocked.holes.size(), 1u);
  EXPECT_GT(with_hole.outer.at(0).size(), blocked.outer.at(0).size());
}

TEST(DiamondAndU, a_hatch_that_narrows_to_the_width_keeps_the_room_closed) {
  // The hatch narrows to 1 at its lower end, so a diamond of width 1 touches both of its sides
  // there.
  EXPECT_EQ(sums_of(Rational(1, 10), 0).closed.holes.size(), 1u);
  EXPECT_TRUE(sums_of(Rational(1, 10), 0).open.dangling_edges.empty());
}

}  // namespace
}  // namespace oplus
