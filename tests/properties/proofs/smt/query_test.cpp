// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/query.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "properties/proofs/smt/run.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/families/random.hpp"

namespace oplus::smt {
namespace {

Formula sign_of_x(const Values& values, const Signs& signs) {
  return Formula::sign_of(values.number("x"), signs);
}

/// "If x > 0, then x >= 0".
Query true_query() {
  return {
      .id = "lemma-2.2.5.of-a-test",
      .unknowns = {any_number("x")},
      .hypotheses = {{"positive",
                      {"x > 0", [](const Values& v) { return sign_of_x(v, {.positive = true}); }}}},
      .conclusion = {"x >= 0",
                     [](const Values& v) {
                       return sign_of_x(v, {.zero = true, .positive = true});
                     }},
      .is_false_by_definition = [](const Model& m) { return sign(m.numbers.at("x")) < 0; }};
}

std::vector<std::string> failures_of(const Query& query) {
  const TemporaryFolder folder;
  write_questions(query, folder.path());
  return run(query, folder.path(), 100).failures;
}

TEST(Queries, HaveNoDefects) {
  EXPECT_EQ(defects_of_queries(queries()), std::vector<std::string>{});
  EXPECT_GE(queries().size(), 50U);
}

TEST(Queries, EachDefectIsFound) {
  EXPECT_EQ(defects_of_queries({true_query()}).size(), 0U);
  EXPECT_EQ(defects_of_queries({true_query(), true_query()}).size(), 1U);
  const auto defects_if = [](const std::function<void(Query&)>& change) {
    Query query = true_query();
    change(query);
    return defects_of_queries({query}).size();
  };
  EXPECT_EQ(defects_if([](Query& q) { q.id = "another.id"; }), 1U);
  EXPECT_EQ(defects_if([](Query& q) { q.id = "lemma-99.x"; }), 1U);
  EXPECT_EQ(defects_if([](Query& q) { q.hypotheses.push_back(q.hypotheses[0]); }), 1U);
  EXPECT_EQ(defects_if([](Query& q) { q.unknowns.clear(); }), 1U);
  EXPECT_EQ(defects_if([](Query& q) { q.unknowns.push_back(any_vector("y")); }), 1U);
  EXPECT_EQ(defects_if([](Query& q) { q.is_false_by_definition = nullptr; }), 1U);
}

TEST(Queries, AreAskedWithoutEachHypothesisAndAlwaysInTheirCase) {
  Query query = true_query();
  query.hypotheses.push_back(query.hypotheses[0]);
  query.hypotheses[1].name = "again";
  query.hypotheses[0].of_twin = {query.conclusion};
  query.in_case = {
      {"x is not 9", [](const Values& v) { return negation(is_zero(v.number("x") - 9)); }}};
  std::string names, conditions;
  for (const Question& question : questions(query)) {
    names += to_string(question) + ' ';
    std::istringstream text(smt_text(query, question, false));
    for (std::string line; std::getline(text, line);)
      if (line.starts_with("; x") || line.starts_with("; not")) conditions += line;
    conditions += '\n';
  }
  EXPECT_EQ(names, "proof hypotheses twin-positive twin-again ");
  EXPECT_EQ(conditions,
            "; x is not 9; x > 0; x > 0; not: x >= 0\n"
            "; x is not 9; x > 0; x > 0\n"
            "; x is not 9; x >= 0; x > 0; not: x >= 0\n"
            "; x is not 9; x > 0; not: x >= 0\n");
}

TEST(QueryRun, PassesWhatHolds) {
  EXPECT_EQ(failures_of(true_query()), std::vector<std::string>{});
}

TEST(QueryRun, FailsWhereTheConclusionDoesNotFollow) {
  Query query = true_query();
  query.conclusion.claim = [](const Values& v) {
    return Formula::sign_of(v.number("x") - 1, {.zero = true, .positive = true});
  };
  const std::vector<std::string> failures = failures_of(query);
  ASSERT_GE(failures.size(), 2U);
  EXPECT_NE(failures[0].find("proof, z3: is sat, and was expected to be unsat"), std::string::npos);
  EXPECT_NE(failures[1].find("proof, cvc5: is sat, and was expected to be unsat"),
            std::string::npos);
}

TEST(QueryRun, FailsWhereTheHypothesesContradictEachOther) {
  Query query = true_query();
  query.hypotheses.push_back(
      {"negative", {"x < 0", [](const Values& v) { return sign_of_x(v, {.negative = true}); }}});
  const std::vector<std::string> failures = failures_of(query);
  ASSERT_EQ(failures.size(), 4U) << "of two solvers; the second hypothesis is not needed, either";
  EXPECT_NE(failures[0].find("hypotheses, z3: is unsat"), std::string::npos);
}

TEST(QueryRun, FailsWhereAHypothesisIsNotNeeded) {
  Query query = true_query();
  query.hypotheses.push_back(
      {"not-large", {"x <= 9", [](const Values& v) {
                       return Formula::sign_of(v.number("x") - 9, {.negative = true, .zero = true});
                     }}});
  const std::vector<std::string> failures = failures_of(query);
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_NE(failures[0].find("twin-not-large, z3: is unsat, and was expected to be sat"),
            std::string::npos);
}

TEST(QueryRun, FailsWhereTheModelIsNotACounterexampleByDefinition) {
  Query query = true_query();
  query.is_false_by_definition = [](const Model&) { return false; };
  const std::vector<std::string> failures = failures_of(query);
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_NE(failures[0].find("by the definitions the model is not a counterexample"),
            std::string::npos);
}

TEST(QueryRun, FailsAtTheTimeLimit) {
  const TemporaryFolder folder;
  write_questions(true_query(), folder.path());
  EXPECT_EQ(run(true_query(), folder.path(), 1e-9).failures.size(), 6U);
}

/// Small numbers, so that many signs are zero.
Model random_model(const Query& query, Random& random) {
  Model model;
  for (const Unknown& unknown : query.unknowns) {
    for (const std::string& name : numbers_of(unknown)) {
      const int numerator = uniform(random, -3, 3);
      model.numbers[name] = Rational(numerator, uniform(random, 1, 2));
      model.numbers[name].canonicalize();
    }
    for (const std::string& name : flags_of(unknown)) model.flags[name] = one_in(random, 2);
  }
  return model;
}

class EachQuery : public testing::TestWithParam<std::size_t> {
 protected:
  const Query& query() const { return queries()[GetParam()]; }
};

/// The transfer: what is proved of the formulas is proved of the code.
TEST_P(EachQuery, FormulasAgreeWithTheCodeOnNumbers) {
  std::vector<Condition> conditions = {query().conclusion};
  conditions.insert(conditions.end(), query().in_case.begin(), query().in_case.end());
  for (const Hypothesis& hypothesis : query().hypotheses)
    conditions.push_back(hypothesis.condition);
  Random random(7);
  for (const Condition& condition : conditions) {
    const Formula formula = condition.in(Values());
    EXPECT_FALSE(formula.value()) << condition.says;
    for (int i = 0; i < 300; ++i) {
      const Model model = random_model(query(), random);
      const bool holds = condition.in(Values(model)).value().value();
      ASSERT_EQ(formula.holds_in(model), holds) << condition.says;
    }
  }
}

/// What the solvers prove for all numbers, tested on some.
TEST_P(EachQuery, HasNoCounterexampleAmongSmallNumbers) {
  const Formula counterexample = formula_of(query(), {Asked::proof}, Values());
  Random random(8);
  for (int i = 0; i < 2000; ++i)
    ASSERT_FALSE(counterexample.holds_in(random_model(query(), random)));
}

INSTANTIATE_TEST_SUITE_P(, EachQuery, testing::Range<std::size_t>(0, queries().size()),
                         [](const testing::TestParamInfo<std::size_t>& parameter) {
                           std::string name = queries()[parameter.param].id;
                           for (char& c : name)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return name;
                         });

}  // namespace
}  // namespace oplus::smt
