// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded models that the solvers found for statements with one hypothesis dropped: each is a
// counterexample to the rest of the statement, by the definitions. No solver is needed.
#include <gtest/gtest.h>

#include <fstream>

#include "properties/proofs/smt/report.hpp"
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
    words.erase("counterexamples");
    EXPECT_EQ(words, to_json(queries()[i])) << queries()[i].id;
  }
}

TEST(RecordedResults, AreAsExpected) {
  const nlohmann::ordered_json results = recorded();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::vector<Question> asked = questions(queries().at(i));
    EXPECT_EQ(results[i]["answers"].size(), asked.size()) << queries()[i].id;
    for (const Question& question : asked)
      for (const Solver& solver : solvers())
        EXPECT_EQ(results[i]["answers"][to_string(question)][solver.name],
                  is_expected_satisfiable(question.asked) ? "sat" : "unsat")
            << queries()[i].id << ", " << to_string(question);
  }
}

/// Calls f(query, hypothesis, the recorded counterexample without it) for all of them.
template <typename F>
void for_each_counterexample(F f) {
  const nlohmann::ordered_json results = recorded();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Query& query = queries().at(i);
    for (const Hypothesis& hypothesis : query.hypotheses) {
      SCOPED_TRACE(query.id + " without " + hypothesis.name);
      f(query, hypothesis, model_of_json(results[i]["counterexamples"][hypothesis.name]));
    }
  }
}

TEST(RecordedCounterexamples, SatisfyTheOtherHypotheses) {
  for_each_counterexample([](const Query& query, const Hypothesis& dropped, const Model& model) {
    EXPECT_EQ(formula_of(query, {Asked::twin, dropped.name}, Values(model)).value(), true);
    for (const Hypothesis& hypothesis : query.hypotheses)
      EXPECT_EQ(hypothesis.condition.in(Values(model)).value(), hypothesis.name != dropped.name)
          << hypothesis.name;
  });
}

TEST(RecordedCounterexamples, AreCounterexamplesByTheDefinitions) {
  for_each_counterexample([](const Query& query, const Hypothesis&, const Model& model) {
    EXPECT_TRUE(query.is_false_by_definition(model));
  });
}

}  // namespace
}  // namespace oplus::smt
