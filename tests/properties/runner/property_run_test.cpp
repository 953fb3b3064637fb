// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/property_run.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "properties/runner/registry.hpp"
#include "properties/runner/shrinking.hpp"

namespace oplus {
namespace {

Statement statement_that(std::function<Outcome(const Summands&)> check) {
  Statement s;
  s.id = "fact-of-a-test";
  s.sources = {{"grid", 6, 2}, {"components", 4, 1}};
  s.check = std::move(check);
  return s;
}

Outcome always(Outcome::Kind kind) { return {kind, "as the test wants", {{"looks", 1}}}; }

Statement that_always(Outcome::Kind kind) {
  return statement_that([kind](const Summands&) { return always(kind); });
}

RunOptions options(std::size_t cases) {
  RunOptions result;
  result.cases = cases;
  return result;
}

TEST(PropertyRun, RunsAsManyCasesAsAskedAndCountsThem) {
  const PropertyRun run = run_property(that_always(Outcome::Kind::holds), options(60));
  EXPECT_TRUE(run.passed());
  EXPECT_EQ(run.run, 60U);
  EXPECT_EQ(run.discarded, 0U);
  EXPECT_EQ(run.counts.at("looks"), 60U);
  EXPECT_EQ(run.families.at("grid") + run.families.at("components"), 60U);
  EXPECT_EQ(run.classes.at("several components"), run.families.at("components"));
}

TEST(PropertyRun, FailsOnZeroCases) {
  const PropertyRun run = run_property(that_always(Outcome::Kind::holds), options(0));
  EXPECT_FALSE(run.passed());
  EXPECT_EQ(run.complaints.front(), "no case was run");
}

TEST(PropertyRun, FailsWhereEverythingIsDiscarded) {
  const PropertyRun run = run_property(that_always(Outcome::Kind::discarded), options(5));
  EXPECT_FALSE(run.passed());
  EXPECT_EQ(run.run, 0U);
  EXPECT_GT(run.discarded, 0U);
}

TEST(PropertyRun, FailsOnAShortRun) {
  std::size_t calls = 0;
  const PropertyRun run =
      run_property(statement_that([&](const Summands&) {
                     return always(++calls <= 7 ? Outcome::Kind::holds : Outcome::Kind::discarded);
                   }),
                   options(20));
  EXPECT_FALSE(run.passed());
  EXPECT_EQ(run.run, 7U);
  EXPECT_EQ(run.complaints.back(), "only 7 of 20 cases were run");
}

TEST(PropertyRun, FailsOnAMissedShareOnly) {
  Statement s = that_always(Outcome::Kind::holds);
  s.promises = {{"several components", 10}};
  EXPECT_TRUE(run_property(s, options(100)).passed());
  s.promises = {{"several components", 90}};
  const PropertyRun run = run_property(s, options(100));
  EXPECT_TRUE(run.shares_judged);
  ASSERT_EQ(run.complaints.size(), 1U);
  EXPECT_NE(run.complaints[0].find("several components"), std::string::npos);
}

TEST(PropertyRun, FailsOnAMissedShareOfACount) {
  std::size_t calls = 0;
  Statement s = statement_that([&](const Summands&) {
    return Outcome{Outcome::Kind::holds, "", {{"cases with luck", ++calls % 4 == 0 ? 1 : 0}}};
  });
  s.promises = {{"cases with luck", 25}};
  EXPECT_TRUE(run_property(s, options(100)).passed());
  s.promises = {{"cases with luck", 26}};
  const PropertyRun run = run_property(s, options(100));
  ASSERT_EQ(run.complaints.size(), 1U);
  EXPECT_NE(run.complaints[0].find("cases with luck, saw 25 of 100"), std::string::npos);
  s.promises = {{"cases with talent", 1}};
  EXPECT_EQ(run_property(s, options(100)).complaints.size(), 1U);
}

TEST(PropertyRun, SaysThatTooFewCasesRanToJudgeShares) {
  Statement s = that_always(Outcome::Kind::holds);
  s.promises = {{"several components", 90}};
  const PropertyRun run = run_property(s, options(cases_to_judge_shares - 1));
  EXPECT_TRUE(run.passed());
  EXPECT_FALSE(run.shares_judged);
}

TEST(PropertyRun, ShrinksAFailingCaseUntilNoSmallerOneFails) {
  const auto fails = [](const Summands& s) { return vertex_count(s.p) >= 4; };
  const Statement s = statement_that([&](const Summands& summands) {
    return always(fails(summands) ? Outcome::Kind::fails : Outcome::Kind::holds);
  });
  const PropertyRun run = run_property(s, options(100));
  EXPECT_FALSE(run.passed());
  ASSERT_TRUE(run.counterexample.has_value());
  EXPECT_EQ(run.counterexample->why, "as the test wants");
  EXPECT_GT(run.counterexample->shrinks, 0U);
  const Summands& shrunk = run.counterexample->summands;
  EXPECT_EQ(vertex_count(shrunk.p), 4U);
  EXPECT_EQ(vertex_count(shrunk.q), 3U);
  EXPECT_TRUE(fails(shrunk));
  for (const Summands& step : smaller(shrunk)) EXPECT_FALSE(fails(step));
}

TEST(PropertyRun, KeepsTheFirstFailureWhereShrinkingIsOff) {
  RunOptions without = options(10);
  without.shrink = false;
  const PropertyRun run = run_property(that_always(Outcome::Kind::fails), without);
  ASSERT_TRUE(run.counterexample.has_value());
  EXPECT_EQ(run.counterexample->shrinks, 0U);
  EXPECT_EQ(run.run, 1U);
}

TEST(PropertyRun, FailsOnAnException) {
  const PropertyRun run = run_property(
      statement_that([](const Summands&) -> Outcome { throw std::logic_error("broken inside"); }),
      options(10));
  ASSERT_TRUE(run.counterexample.has_value());
  EXPECT_EQ(run.complaints.front(), "threw: broken inside");
}

TEST(PropertyRun, FailsWhereNoPairCanBeMade) {
  Statement s = that_always(Outcome::Kind::holds);
  for (const Source& source : {Source{"no such family", 4, 1}, Source{"grid", 1, 1}}) {
    s.sources = {source};
    EXPECT_FALSE(run_property(s, options(10)).passed()) << source.family;
  }
}

Statement enumerated_as(const Enumeration& enumeration) {
  Statement s = that_always(Outcome::Kind::holds);
  s.enumerate = [enumeration] { return enumeration; };
  return s;
}

TEST(PropertyRun, GoesThroughAnEnumerationAndTriesPairsAsWell) {
  const PropertyRun run = run_property(enumerated_as({12, ""}), options(20));
  EXPECT_TRUE(run.passed());
  ASSERT_TRUE(run.enumeration.has_value());
  EXPECT_EQ(run.enumeration->cases, 12U);
  EXPECT_EQ(run.run, 20U);
  EXPECT_FALSE(run_property(that_always(Outcome::Kind::holds), options(20)).enumeration);
}

TEST(PropertyRun, FailsOnAnExceptionInAnEnumeration) {
  Statement s = enumerated_as({});
  s.enumerate = []() -> Enumeration { throw std::logic_error("broken inside"); };
  EXPECT_EQ(run_property(s, options(20)).complaints,
            std::vector<std::string>{"enumeration: threw: broken inside"});
}

TEST(PropertyRun, FailsWithNeitherPairsNorEnumeration) {
  EXPECT_FALSE(run_property(statement_that(nullptr), options(20)).passed());
}

TEST(PropertyRun, StillFailsOnPairsWhereTheEnumerationHolds) {
  Statement s = enumerated_as({12, ""});
  s.check = [](const Summands&) { return always(Outcome::Kind::fails); };
  EXPECT_FALSE(run_property(s, options(20)).passed());
}

std::vector<Summands> pairs_of(const std::string& id, std::uint64_t seed) {
  std::vector<Summands> pairs;
  Statement s = statement_that([&](const Summands& summands) {
    pairs.push_back(summands);
    return always(Outcome::Kind::holds);
  });
  s.id = id;
  RunOptions twenty = options(20);
  twenty.seed = seed;
  run_property(s, twenty);
  return pairs;
}

TEST(PropertyRun, GivesEachStatementAndSeedItsOwnPairsAndAlwaysTheSame) {
  EXPECT_EQ(pairs_of("fact-a", 1), pairs_of("fact-a", 1));
  EXPECT_NE(pairs_of("fact-a", 1), pairs_of("fact-b", 1));
  EXPECT_NE(pairs_of("fact-a", 1), pairs_of("fact-a", 2));
}

TEST(PropertyRun, DerivesTheSameSeedOnEveryCompiler) {
  EXPECT_EQ(seed_of("lemma-4.1.4", 1), 5065818344319634436U);
  std::set<std::uint64_t> seeds;
  for (const Statement& s : statements()) seeds.insert(seed_of(s.id, 1));
  EXPECT_EQ(seeds.size(), statements().size());
}

}  // namespace
}  // namespace oplus
