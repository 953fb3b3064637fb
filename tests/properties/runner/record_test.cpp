// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/record.hpp"

#include <gtest/gtest.h>

#include "reference/io/invalid_input.hpp"

namespace oplus {
namespace {

const Summands pair = {
    Region{{{{{0, 0}, {1, 0}, {0, 1}}, {}}}},
    Region{{{{{0, 0}, {Rational(1, 3), 0}, {2, 2}}, {}}}},
};

TEST(RecordedRun, SurvivesJson) {
  const RecordedRun run = {.statement = "lemma-9.9.9",
                           .enumerated = 12,
                           .run = 30,
                           .discarded = 2,
                           .families = {{"grid", 20}, {"tight", 10}},
                           .classes = {{"holes", 3}},
                           .counts = {{"edges", 400}},
                           .typical = pair};
  const std::string text = to_json(std::vector{run, RecordedRun{.statement = "fact-none"}});
  const std::vector<RecordedRun> read = runs_of_json(text, "runs.json");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].statement, run.statement);
  EXPECT_EQ(read[0].enumerated, run.enumerated);
  EXPECT_EQ(read[0].run, run.run);
  EXPECT_EQ(read[0].discarded, run.discarded);
  EXPECT_EQ(read[0].families, run.families);
  EXPECT_EQ(read[0].classes, run.classes);
  EXPECT_EQ(read[0].counts, run.counts);
  EXPECT_EQ(read[0].typical, run.typical);
  EXPECT_FALSE(read[1].enumerated);
  EXPECT_FALSE(read[1].typical);
  EXPECT_EQ(to_json(read), text);
}

TEST(RecordedKill, SurvivesJson) {
  const Kill kill{"fault", "lemma-9.9.9", true, false, 7, "at (1, 2) it is not so", pair};
  const std::string text = to_json(std::vector{kill, Kill{"other", "fact-none", true, true}});
  const std::vector<Kill> read = kills_of_json(text, "kills.json");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].mutant, kill.mutant);
  EXPECT_EQ(read[0].statement, kill.statement);
  EXPECT_TRUE(read[0].killed);
  EXPECT_FALSE(read[0].by_enumeration);
  EXPECT_EQ(read[0].cases, kill.cases);
  EXPECT_EQ(read[0].why, kill.why);
  EXPECT_EQ(read[0].shrunk, kill.shrunk);
  EXPECT_TRUE(read[1].by_enumeration);
  EXPECT_FALSE(read[1].shrunk);
  EXPECT_EQ(to_json(read), text);
}

TEST(RecordedKill, LeavesOutWhereABrokenContractStands) {
  const auto why_read_back = [](const std::string& why) {
    return kills_of_json(to_json(std::vector{Kill{"m", "s", true, false, 1, why}}), "k")[0].why;
  };
  EXPECT_EQ(why_read_back("threw: postcondition (Lemma 4) broken: !mark at ../../a.cpp:116"),
            "threw: postcondition (Lemma 4) broken: !mark");
  EXPECT_EQ(why_read_back("the points at (1, 2) differ"), "the points at (1, 2) differ");
}

TEST(Records, RefuseWhatIsNone) {
  for (const char* text : {"", "[", "[{}]", "{}x", "[{\"statement\": 3}]"}) {
    EXPECT_THROW(runs_of_json(text, "runs.json"), InvalidInput) << text;
    EXPECT_THROW(kills_of_json(text, "kills.json"), InvalidInput) << text;
  }
  const std::string bad_pair =
      "[{\"mutant\":\"m\",\"statement\":\"s\",\"killed\":true,\"by_enumeration\":false,"
      "\"cases\":1,\"why\":\"\",\"shrunk\":{\"p\":\"POLYGON((0 0,1 1))\",\"q\":\"POLYGON EMPTY\"}}]";
  EXPECT_THROW(kills_of_json(bad_pair, "kills.json"), InvalidInput);
}

}  // namespace
}  // namespace oplus
