// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded models that the solvers found for statements with a hypothesis dropped: each is a
// counterexample to the rest of the statement, by the definitions. No solver is needed.
#include <gtest/gtest.h>

#include <fstream>

#include "properties/proofs/smt/report.hpp"
#include "properties/runner/registry.hpp"
#include "properties/runner/source_tree.hpp"

namespace oplus::smt {
namespace {

nlohmann::ordered_json recorded() {
  std::ifstream file(source_root() / "properties/proofs/smt/results.json");
  return nlohmann::ordered_json::parse(file)["queries"];
}

TEST(RecordedResults, AreOfTheseQueries) {
  const nlohmann::ordered_json results = recorded();
  ASSERT_EQ(results.size(), queries().size())
      << "oplus-check smt --record properties/proofs/smt/results.json";
  for (std::size_t i = 0; i < results.size(); ++i) {
    nlohmann::ordered_json words = results[i];
    words.erase("answers");
    words.erase("counterexample");
    EXPECT_EQ(words, to_json(queries()[i])) << queries()[i].id;
  }
}

TEST(RecordedResults, AreAsExpected) {
  for (const nlohmann::ordered_json& result : recorded()) {
    for (const Solver& solver : solvers()) {
      for (const Asked asked : {Asked::proof, Asked::hypotheses, Asked::twin})
        EXPECT_EQ(result["answers"][to_string(asked)][solver.name],
                  is_expected_satisfiable(asked) ? "sat" : "unsat")
            << result["id"];
    }
  }
}

TEST(RecordedCounterexamples, SatisfyTheOtherHypotheses) {
  const nlohmann::ordered_json results = recorded();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Query& query = queries().at(i);
    const Model model = model_of_json(results[i]["counterexample"]);
    EXPECT_EQ(formula_of(query, Asked::twin, Values(model)).value(), true) << query.id;
    for (const Hypothesis& hypothesis : query.hypotheses)
      EXPECT_EQ(hypothesis.condition.in(Values(model)).value(), hypothesis.name != query.dropped)
          << query.id << ", " << hypothesis.name;
  }
}

TEST(RecordedCounterexamples, AreCounterexamplesByTheDefinitions) {
  const nlohmann::ordered_json results = recorded();
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_TRUE(queries().at(i).is_false_by_definition(model_of_json(results[i]["counterexample"])))
        << queries()[i].id;
}

}  // namespace
}  // namespace oplus::smt
