// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/pair_mutation.hpp"

#include <gtest/gtest.h>

#include <map>

#include "checked/slide/numbers.hpp"
#include "checked/slide/scaling.hpp"
#include "properties/fuzz/realized_pair.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/chains/validity.hpp"

namespace oplus {
namespace {

/// What a run of the mutator has seen, each from the plan before.
struct Seen {
  int cases = 0;
  int as_planned = 0;
  int holes = 0;
  int several_components = 0;
  int touching = 0;
  int fractions = 0;
  std::map<std::size_t, int> bits;  ///< as slide counts them
};

Seen walk(std::uint64_t seed, int cases) {
  Random random(seed);
  Seen seen;
  std::string bytes;
  std::string other = encoded(new_plan(random));
  for (int i = 0; i < cases; ++i) {
    const std::string before = bytes;
    bytes = one_in(random, 8) ? crossed_pair(random, bytes, other) : mutated_pair(random, bytes);
    if (one_in(random, 20)) bytes.clear();
    other = before;
    if (bytes.empty()) continue;
    ++seen.cases;
    const auto pair = realized(decoded(bytes));
    if (!pair || !pair->is_as_planned()) continue;
    ++seen.as_planned;
    const auto& [p, q] = pair->summands;
    EXPECT_FALSE(find_defect(p) || find_defect(q)) << i;
    for (const Region* region : {&p, &q}) {
      for (const Component& component : region->components) {
        seen.holes += !component.holes.empty();
        seen.fractions += component.outer[0].x.get_den() != 1;
      }
      seen.several_components += region->components.size() > 1;
      seen.touching += !touching_points(*region).empty();
    }
    ++seen.bits[slide::scaling_of(p, q).bits];
  }
  return seen;
}

/// And on both sides of the limits of slide's stages of numbers, and just there.
TEST(PairMutation, stays_valid_and_has_all_degeneracies) {
  const Seen seen = walk(6, 600);
  EXPECT_GE(seen.as_planned * 100, seen.cases * 99) << "of " << seen.cases;
  EXPECT_GT(seen.holes, seen.cases / 4);
  EXPECT_GT(seen.several_components, seen.cases / 4);
  EXPECT_GT(seen.touching, seen.cases / 10);
  EXPECT_GT(seen.fractions, seen.cases / 20);
  int small = 0, wide = 0, any = 0;
  for (const auto& [bits, times] : seen.bits)
    (bits <= slide::SmallNumbers::bits  ? small
     : bits <= slide::WideNumbers::bits ? wide
                                        : any) += times;
  EXPECT_GT(small, seen.cases / 10);
  EXPECT_GT(wide, seen.cases / 10);
  EXPECT_GT(any, seen.cases / 10);
  for (const std::size_t limit : {slide::SmallNumbers::bits, slide::WideNumbers::bits}) {
    EXPECT_TRUE(seen.bits.contains(limit)) << limit;
    EXPECT_TRUE(seen.bits.contains(limit + 1)) << limit;
  }
}

class PairChangeTest : public testing::TestWithParam<std::size_t> {};

/// No change is dead: each leads from some plan to another one that is valid as it is planned.
TEST_P(PairChangeTest, leads_to_a_valid_pair) {
  const PairChange& change = pair_changes().at(GetParam());
  Random random(8);
  int valid = 0;
  for (int i = 0; i < 300 && valid < 3; ++i) {
    const PairPlan before = new_plan(random);
    PairPlan after = before;
    if (!change.apply(random, after) || after == before) continue;
    ASSERT_EQ(decoded(encoded(after)), after);
    const auto pair = realized(after);
    valid += pair && pair->is_as_planned();
  }
  EXPECT_EQ(valid, 3);
}

INSTANTIATE_TEST_SUITE_P(Each, PairChangeTest,
                         testing::Range(std::size_t{0}, pair_changes().size()),
                         [](const auto& test) { return pair_changes()[test.param].name; });

TEST(PairMutation, is_the_same_for_the_same_random_numbers) {
  Random first(9), second(9);
  std::string a, b;
  for (int i = 0; i < 30; ++i) {
    a = mutated_pair(first, a);
    b = mutated_pair(second, b);
    ASSERT_EQ(a, b) << i;
  }
}

}  // namespace
}  // namespace oplus
