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

TEST(RecordedRuns, SurviveJson) {
  const PropertyRun run = {.statement = "lemma-9.9.9",
                           .title = "A title",
                           .enumeration = Enumeration{12, ""},
                           .run = 30,
                           .discarded = 2,
                           .classes = {{"holes", 3}},
                           .families = {{"grid", 20}, {"tight", 10}},
                           .counts = {{"edges", 400}},
                           .typical = pair};
  const std::string text = to_json({run, {.statement = "fact-none", .complaints = {"no case"}}});
  EXPECT_NE(text.find("\"passed\": 1,\n\"failed\": 1}\n"), std::string::npos) << text;
  const std::vector<PropertyRun> read = runs_of_json(text, "runs.json");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].statement, run.statement);
  EXPECT_EQ(read[0].title, run.title);
  EXPECT_EQ(read[0].enumeration.value().cases, 12U);
  EXPECT_EQ(read[0].run, run.run);
  EXPECT_EQ(read[0].discarded, run.discarded);
  EXPECT_EQ(read[0].families, run.families);
  EXPECT_EQ(read[0].classes, run.classes);
  EXPECT_EQ(read[0].counts, run.counts);
  EXPECT_EQ(read[0].typical, run.typical);
  EXPECT_TRUE(read[0].passed());
  EXPECT_FALSE(read[1].enumeration);
  EXPECT_FALSE(read[1].typical);
  EXPECT_FALSE(read[1].passed());
  EXPECT_EQ(to_json(read), text);
}

TEST(RecordedRuns, SayWhatRefutesAStatement) {
  const PropertyRun run = {
      .statement = "lemma-9.9.9",
      .complaints = {"it is not so"},
      .counterexample = Counterexample{pair, "it is not so", 3, Finding{"a-p.dat", "a-q.dat"},
                                       Point{1, Rational(2, 3)}}};
  EXPECT_NE(to_json({run}).find("\"counterexample\":{\"why\":\"it is not so\","
                                "\"at\":[\"1\",\"2/3\"],"
                                "\"p\":\"POLYGON ((0 0, 1 0, 0 1, 0 0))\","
                                "\"q\":\"POLYGON ((0 0, 1/3 0, 2 2, 0 0))\",\"shrinks\":3,"
                                "\"p_file\":\"a-p.dat\",\"q_file\":\"a-q.dat\","
                                "\"replay\":\"oplus-check properties --theorem lemma-9.9.9 "
                                "--pair a-p.dat a-q.dat\"}"),
            std::string::npos)
      << to_json({run});
}

TEST(Replays, AreCounted) {
  Statement s;
  s.id = "lemma-9.9.9";
  s.title = "A title";
  EXPECT_EQ(to_json({s, s}, {{}, {Outcome::Kind::discarded, "no", {{"edges", 1}}}}),
            "{\"statements\": [\n"
            "{\"statement\":\"lemma-9.9.9\",\"title\":\"A title\",\"outcome\":\"holds\","
            "\"counts\":{}},\n"
            "{\"statement\":\"lemma-9.9.9\",\"title\":\"A title\",\"outcome\":\"does not apply\","
            "\"why\":\"no\",\"counts\":{\"edges\":1}}\n"
            "],\n\"passed\": 1,\n\"failed\": 0,\n\"not_applicable\": 1}\n");
}

TEST(RecordedKills, SurviveJson) {
  const Kill kill{"fault", "lemma-9.9.9",  true, false,
                  7,       "it is not so", pair, Point{1, Rational(2, 3)}};
  const std::string text = to_json({kill, Kill{"other", "fact-none", false, true}}, {"a defect"});
  EXPECT_NE(text.find("\"killed\": 1,\n\"not_killed\": 1,\n\"defects\": [\"a defect\"]}\n"),
            std::string::npos)
      << text;
  const std::vector<Kill> read = kills_of_json(text, "kills.json");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].mutant, kill.mutant);
  EXPECT_EQ(read[0].statement, kill.statement);
  EXPECT_TRUE(read[0].killed);
  EXPECT_FALSE(read[0].by_enumeration);
  EXPECT_EQ(read[0].cases, kill.cases);
  EXPECT_EQ(read[0].why, kill.why);
  EXPECT_EQ(read[0].shrunk, kill.shrunk);
  EXPECT_EQ(read[0].at, kill.at);
  EXPECT_TRUE(read[1].by_enumeration);
  EXPECT_FALSE(read[1].shrunk);
  EXPECT_FALSE(read[1].at);
  EXPECT_EQ(to_json(read, {"a defect"}), text);
}

TEST(RecordedKills, LeaveOutTheLineOfABrokenContract) {
  const auto why_read_back = [](const std::string& why) {
    return kills_of_json(to_json({Kill{"m", "s", true, false, 1, why}}, {}), "k")[0].why;
  };
  EXPECT_EQ(why_read_back("threw: postcondition (Lemma 4) broken: !mark at ../../a.cpp:116"),
            "threw: postcondition (Lemma 4) broken: !mark");
  EXPECT_EQ(why_read_back("the points at (1, 2) differ"), "the points at (1, 2) differ");
}

TEST(Records, RefuseInvalidText) {
  for (const char* text : {"", "[", "[]", "{\"statements\": [{}], \"kills\": [{}]}", "{}x",
                           "{\"statements\": [{\"statement\": 3}]}"}) {
    EXPECT_THROW(runs_of_json(text, "runs.json"), InvalidInput) << text;
    EXPECT_THROW(kills_of_json(text, "kills.json"), InvalidInput) << text;
  }
  const std::string bad_pair =
      "{\"kills\": [{\"mutant\":\"m\",\"statement\":\"s\",\"killed\":true,\"by_enumeration\":false,"
      "\"cases\":1,\"why\":\"\",\"shrunk\":{\"p\":\"POLYGON((0 0,1 1))\",\"q\":\"POLYGON EMPTY\"}}]}";
  EXPECT_THROW(kills_of_json(bad_pair, "kills.json"), InvalidInput);
  const std::string bad_point =
      "{\"kills\": [{\"mutant\":\"m\",\"statement\":\"s\",\"killed\":true,\"by_enumeration\":false,"
      "\"cases\":1,\"why\":\"\",\"at\":[\"1\",\"x\"]}]}";
  EXPECT_THROW(kills_of_json(bad_point, "kills.json"), InvalidInput);
}

}  // namespace
}  // namespace oplus
