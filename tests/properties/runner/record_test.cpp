// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/record.hpp"

#include <gtest/gtest.h>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

const Summands pair = {
    Region{{{{{0, 0}, {1, 0}, {0, 1}}, {}}}},
    Region{{{{{0, 0}, {Rational(1, 3), 0}, {2, 2}}, {}}}},
};

TEST(RecordedRuns, AreAnObjectALine) {
  const PropertyRun run = {.statement = "lemma-9.9.9",
                           .title = "A title",
                           .enumeration = Enumeration{12, ""},
                           .run = 30,
                           .discarded = 2,
                           .classes = {{"holes", 3}},
                           .families = {{"grid", 20}, {"tight", 10}},
                           .counts = {{"edges", 400}},
                           .typical = pair};
  EXPECT_EQ(
      to_json({run, {.statement = "fact-none", .complaints = {"no case"}}}),
      "{\"statements\": [\n"
      "{\"statement\":\"lemma-9.9.9\",\"title\":\"A title\",\"passed\":true,"
      "\"enumerated\":12,\"run\":30,\"discarded\":2,\"families\":{\"grid\":20,\"tight\":10},"
      "\"classes\":{\"holes\":3},\"counts\":{\"edges\":400},\"shares_judged\":false,"
      "\"complaints\":[],\"typical\":{\"p\":\"POLYGON ((0 0, 1 0, 0 1, 0 0))\","
      "\"q\":\"POLYGON ((0 0, 1/3 0, 2 2, 0 0))\"}},\n"
      "{\"statement\":\"fact-none\",\"title\":\"\",\"passed\":false,\"run\":0,\"discarded\":0,"
      "\"families\":{},\"classes\":{},\"counts\":{},\"shares_judged\":false,"
      "\"complaints\":[\"no case\"]}\n"
      "],\n\"passed\": 1,\n\"failed\": 1}\n");
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
  s.text.title = "A title";
  EXPECT_EQ(to_json({s, s}, {{}, {Outcome::Kind::discarded, "no", {{"edges", 1}}}}),
            "{\"statements\": [\n"
            "{\"statement\":\"lemma-9.9.9\",\"title\":\"A title\",\"outcome\":\"holds\","
            "\"counts\":{}},\n"
            "{\"statement\":\"lemma-9.9.9\",\"title\":\"A title\",\"outcome\":\"does not apply\","
            "\"why\":\"no\",\"counts\":{\"edges\":1}}\n"
            "],\n\"passed\": 1,\n\"failed\": 0,\n\"not_applicable\": 1}\n");
}

TEST(RecordedKills, AreAnObjectALine) {
  const Kill kill{"fault", "lemma-9.9.9",  true, false,
                  7,       "it is not so", pair, Point{1, Rational(2, 3)}};
  EXPECT_EQ(to_json({kill, Kill{"other", "fact-none", false, true}}),
            "{\"kills\": [\n"
            "{\"mutant\":\"fault\",\"statement\":\"lemma-9.9.9\",\"killed\":true,"
            "\"by_enumeration\":false,\"cases\":7,\"why\":\"it is not so\",\"at\":[\"1\",\"2/3\"],"
            "\"shrunk\":{\"p\":\"POLYGON ((0 0, 1 0, 0 1, 0 0))\","
            "\"q\":\"POLYGON ((0 0, 1/3 0, 2 2, 0 0))\"}},\n"
            "{\"mutant\":\"other\",\"statement\":\"fact-none\",\"killed\":false,"
            "\"by_enumeration\":true,\"cases\":0,\"why\":\"\"}\n"
            "],\n\"killed\": 1,\n\"not_killed\": 1}\n");
}

TEST(RecordedKills, LeaveOutTheLineOfABrokenContract) {
  const auto recorded = [](const std::string& why) {
    return to_json({Kill{"m", "s", true, false, 1, why}});
  };
  EXPECT_TRUE(has(recorded("threw: postcondition (Lemma 4) broken: !mark at ../../a.cpp:116"),
                  "\"threw: postcondition (Lemma 4) broken: !mark\""));
  EXPECT_TRUE(has(recorded("the points at (1, 2) differ"), "\"the points at (1, 2) differ\""));
}

}  // namespace
}  // namespace oplus
