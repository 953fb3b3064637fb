// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/pair_plan.hpp"

#include <gtest/gtest.h>

#include "properties/fuzz/pair_mutation.hpp"
#include "properties/fuzz/realized_pair.hpp"

namespace oplus {
namespace {

std::string random_bytes(Random& random) {
  std::string bytes(uniform_index(random, 200), '\0');
  for (char& byte : bytes) byte = static_cast<char>(uniform(random, 0, 255));
  return bytes;
}

TEST(PairPlan, survives_being_encoded) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const PairPlan plan = decoded(random_bytes(random));
    ASSERT_EQ(decoded(encoded(plan)), plan) << i;
  }
}

TEST(PairPlan, keeps_within_its_limits_whatever_the_bytes) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const PairPlan plan = decoded(random_bytes(random));
    for (const PlannedSummand* summand : {&plan.p, &plan.q}) {
      std::size_t vertices = 0;
      ASSERT_LE(summand->chains.size(), most_chains);
      for (const PlannedChain& chain : summand->chains) {
        ASSERT_LE(chain.vertices.size(), most_vertices);
        ASSERT_GE(chain.vertices.size(), 3U);
        vertices += chain.vertices.size();
      }
      ASSERT_LE(vertices, most_vertices_in_all);
    }
  }
}

TEST(PairPlan, of_no_bytes_is_empty_and_rejected) {
  EXPECT_EQ(decoded(""), PairPlan{});
  EXPECT_FALSE(realized(decoded("")));
}

TEST(PairPlan, of_a_pair_is_realized_as_that_pair) {
  const Region frame{{{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{{2, 2}, {2, 6}, {6, 6}, {6, 2}}}},
                      {{{3, 3}, {5, 3}, {4, 5}}, {}}}};
  const Summands pair{frame, polygon({{-128, 0}, {127, 0}, {0, 127}})};
  const auto plan = plan_of(pair);
  ASSERT_TRUE(plan);
  EXPECT_EQ(decoded(encoded(*plan)), *plan);
  const auto again = realized(*plan);
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->is_as_planned());
  EXPECT_TRUE(again->summands == pair);
}

TEST(PairPlan, is_of_small_integers_only) {
  const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_TRUE(plan_of(Summands{triangle, triangle}));
  EXPECT_FALSE(plan_of(Summands{triangle, polygon({{0, 0}, {128, 0}, {0, 1}})}));
  EXPECT_FALSE(plan_of(Summands{polygon({{0, 0}, {Rational(1, 2), 0}, {0, 1}}), triangle}));
}

}  // namespace
}  // namespace oplus
