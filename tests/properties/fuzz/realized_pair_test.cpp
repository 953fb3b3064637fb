// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/realized_pair.hpp"

#include <gtest/gtest.h>

#include "properties/fuzz/pair_mutation.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/chains/validity.hpp"

namespace oplus {
namespace {

PlannedChain chain(bool is_hole, std::vector<PlannedVertex> vertices) {
  return {is_hole, std::move(vertices)};
}

const PlannedChain square = chain(false, {{0, 0}, {8, 0}, {8, 8}, {0, 8}});

PairPlan plan_with(std::vector<PlannedChain> of_p) {
  PairPlan plan;
  plan.p.chains = std::move(of_p);
  plan.q.chains = {square};
  return plan;
}

TEST(RealizedPair, orients_chains) {
  const auto pair = realized(plan_with(
      {chain(false, {{0, 0}, {0, 8}, {8, 8}, {8, 0}}), chain(true, {{2, 2}, {4, 2}, {2, 4}})}));
  ASSERT_TRUE(pair);
  EXPECT_TRUE(pair->is_as_planned());
  const Component& component = pair->summands.p.components.at(0);
  EXPECT_GT(twice_area(component.outer), 0);
  EXPECT_LT(twice_area(component.holes.at(0)), 0);
}

TEST(RealizedPair, untangles_a_chain_that_crosses_itself) {
  const auto pair = realized(plan_with({chain(false, {{0, 0}, {8, 8}, {8, 0}, {0, 8}})}));
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->untangled, 1U);
  EXPECT_EQ(area(pair->summands.p), 64);
}

TEST(RealizedPair, leaves_out_what_is_not_valid) {
  const PlannedChain beside = chain(true, {{20, 0}, {24, 0}, {20, 4}});
  const PlannedChain line = chain(false, {{0, 0}, {1, 1}, {2, 2}});
  const PlannedChain across = chain(false, {{4, 4}, {12, 4}, {4, 6}});
  const auto pair = realized(plan_with({square, beside, line, across}));
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->left_out, 3U);
  EXPECT_EQ(pair->summands.p.components.size(), 1U);
  EXPECT_TRUE(pair->summands.p.components[0].holes.empty());
  EXPECT_FALSE(realized(plan_with({line})));
  EXPECT_FALSE(realized(plan_with({})));
}

TEST(RealizedPair, keeps_chains_that_touch) {
  const auto pair = realized(plan_with(
      {square, chain(true, {{0, 0}, {4, 2}, {2, 4}}), chain(false, {{8, 8}, {9, 8}, {9, 9}})}));
  ASSERT_TRUE(pair);
  EXPECT_TRUE(pair->is_as_planned());
  EXPECT_EQ(touching_points(pair->summands.p).size(), 2U);
}

/// The largest coordinate has as many bits as the magnitude says.
TEST(RealizedPair, is_as_large_as_its_magnitude) {
  for (std::size_t i = 1; i < magnitudes.size(); ++i) {
    PairPlan plan = plan_with({square});
    plan.magnitude = static_cast<std::uint8_t>(i);
    const auto pair = realized(plan);
    ASSERT_TRUE(pair);
    const mpz_class largest = pair->summands.p.components[0].outer[2].x.get_num();
    EXPECT_EQ(mpz_sizeinbase(largest.get_mpz_t(), 2), magnitudes[i]);
  }
}

/// Whatever the bytes, what is realized is valid; of plans with up to twelve bytes changed, half are
/// realized.
TEST(RealizedPair, is_valid_or_nullopt_whatever_the_bytes) {
  Random random(5);
  int valid = 0;
  constexpr int cases = 300;
  for (int i = 0; i < cases; ++i) {
    std::string bytes = encoded(new_plan(random));
    for (int changes = uniform(random, 1, 12); changes > 0; --changes) {
      const std::size_t at = uniform_index(random, bytes.size());
      bytes[at] = static_cast<char>(uniform(random, 0, 255));
    }
    const auto pair = realized(decoded(bytes));
    if (!pair) continue;
    ++valid;
    ASSERT_FALSE(find_defect(pair->summands.p)) << i;
    ASSERT_FALSE(find_defect(pair->summands.q)) << i;
    ASSERT_FALSE(pair->summands.p.components.empty());
    ASSERT_FALSE(pair->summands.q.components.empty());
  }
  EXPECT_GT(valid, cases / 2);
}

}  // namespace
}  // namespace oplus
