// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/judge.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "reference/definitions/difference.hpp"
#include "reference/families/pairs.hpp"
#include "reference/oracle/oracle.hpp"
#include "tests/properties/compare/faulty_engines.hpp"

namespace oplus {
namespace {

const Task frame_and_square{
    "",
    {{{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{2, 2}, {2, 7}, {7, 7}, {7, 2}}}}}},
     polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})}};
const Task frame_and_plug{
    "",
    {{{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}}}},
     polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}})}};

const Engine right = named_engine("right", oracle_sum);
const Engine without_holes = changed([](PlanarSet& sum) { sum.holes.clear(); });
const Engine without_isolated_vertices =
    changed([](PlanarSet& sum) { sum.isolated_vertices.clear(); });
const Engine throwing = changed([](PlanarSet&) { throw std::runtime_error("no luck, 13 times"); });

TEST(Judge, passes_the_right_sums_and_classifies_the_pair) {
  const JudgedPair result = judged(frame_and_square, {.engines = {right}});
  ASSERT_EQ(result.sums.size(), 2U);
  for (const JudgedSum& sum : result.sums) EXPECT_EQ(sum.ruling, "passed");
  EXPECT_TRUE(result.classes.holes);
  EXPECT_FALSE(result.classes.several_components);
  EXPECT_EQ(result.right.value().closed.holes.size(), 1U);
}

TEST(Judge, sees_a_lost_hole_and_a_point_that_shows_it) {
  const JudgedPair result = judged(frame_and_square, {.engines = {right, without_holes}});
  ASSERT_EQ(result.sums.size(), 4U);
  EXPECT_FALSE(result.sums[1].wrong);
  const WrongSum& wrong = result.sums[2].wrong.value();
  EXPECT_EQ(wrong.engine, "changed");
  EXPECT_EQ(wrong.boundary, Boundary::closed);
  EXPECT_EQ(wrong.failure.kind, "hole lost");
  EXPECT_EQ(locate(wrong.failure.witness.value(), wrong.right.value()), Location::outside);
  EXPECT_EQ(locate(*wrong.failure.witness, wrong.given.value()), Location::inside);
}

TEST(Judge, sees_a_lost_isolated_vertex_in_the_open_sum_only) {
  const JudgedPair result = judged(frame_and_plug, {.engines = {without_isolated_vertices}});
  EXPECT_EQ(result.sums[0].ruling, "passed");
  EXPECT_EQ(result.sums[1].wrong.value().failure.witness, (Point{3, 3}));
}

TEST(Judge, a_judge_that_throws_is_counted_and_its_sums_are_not_passed) {
  Rules rules{.engines = {right}};
  rules.judge = {"broken", "the broken judge", 1300, [](const Region&, const Region&) -> RightSums {
                   throw std::runtime_error("no luck");
                 }};
  const JudgedPair result = judged(frame_and_square, rules);
  ASSERT_EQ(result.sums.size(), 3U);
  EXPECT_EQ(result.sums[0].why, "the broken judge threw");
  EXPECT_EQ(result.sums[1].ruling, "skipped");
  EXPECT_EQ(result.sums[2].ruling, "crashed");
  EXPECT_EQ(result.sums[2].wrong.value().engine, "broken");
}

TEST(Judge, skips_what_is_too_large_and_says_so) {
  const Task large{"", fork_and_l(3)};
  const JudgedSum skipped = judged(large, {.engines = {throwing}, .largest = 10}).sums.at(0);
  EXPECT_EQ(skipped.ruling, "skipped");
  EXPECT_NE(skipped.why.find("the oracle takes at most 10"), std::string::npos) << skipped.why;
  const Rules beyond{.engines = {throwing, right}, .largest = 10, .asks_beyond = true};
  EXPECT_EQ(judged(large, beyond).sums.at(0).ruling, "crashed");
  EXPECT_EQ(judged(large, beyond).sums.at(2).ruling, "skipped");
}

}  // namespace
}  // namespace oplus
