// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/query.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "properties/runner/registry.hpp"

namespace oplus::smt {

namespace {

std::vector<Query>& registered_queries() {
  static std::vector<Query> all;
  return all;
}

/// What is asserted, in words and as a formula.
std::vector<Condition> assertions(const Query& query, const Question& question) {
  std::vector<Condition> all = query.in_case;
  for (const Hypothesis& hypothesis : query.hypotheses) {
    if (question.asked == Asked::twin && hypothesis.name == question.dropped)
      all.insert(all.end(), hypothesis.of_twin.begin(), hypothesis.of_twin.end());
    else
      all.push_back(hypothesis.condition);
  }
  if (question.asked != Asked::hypotheses)
    all.push_back({"not: " + query.conclusion.says, [&query](const Values& values) {
                     return negation(query.conclusion.in(values));
                   }});
  return all;
}

Formula::Names names_in(const Query& query) {
  Formula::Names names;
  for (const Question& question : questions(query))
    formula_of(query, question, Values()).add_names_to(names);
  return names;
}

}  // namespace

Formula Condition::in(const Values& values) const {
  if (values.are_known()) return claim(values);
  if (!*of_unknowns) *of_unknowns = claim(values);
  return **of_unknowns;
}

bool is_expected_satisfiable(Asked asked) { return asked != Asked::proof; }

std::string to_string(const Question& question) {
  switch (question.asked) {
    case Asked::hypotheses:
      return "hypotheses";
    case Asked::twin:
      return "twin-" + question.dropped;
    case Asked::proof:
      break;
  }
  return "proof";
}

std::vector<Question> questions(const Query& query) {
  std::vector<Question> all = {{Asked::proof}, {Asked::hypotheses}};
  for (const Hypothesis& hypothesis : query.hypotheses)
    all.push_back({Asked::twin, hypothesis.name});
  return all;
}

const std::vector<Query>& queries() {
  static const std::vector<Query> sorted = [] {
    std::vector<Query> all = registered_queries();
    std::stable_sort(all.begin(), all.end(),
                     [](const Query& a, const Query& b) { return a.id < b.id; });
    return all;
  }();
  return sorted;
}

RegisteredQueries::RegisteredQueries(const std::vector<Query>& all) {
  registered_queries().insert(registered_queries().end(), all.begin(), all.end());
}

std::vector<std::string> defects_of_queries(const std::vector<Query>& all) {
  std::vector<std::string> found;
  std::set<std::string> statement_ids, ids;
  for (const Statement& statement : statements()) statement_ids.insert(statement.id);
  for (const Query& query : all) {
    if (!ids.insert(query.id).second) found.push_back(query.id + ": used twice");
    if (statement_ids.count(query.statement()) == 0)
      found.push_back(query.id + ": no statement " + query.statement());
    if (query.hypotheses.empty()) found.push_back(query.id + ": no hypothesis");
    std::set<std::string> named;
    for (const Hypothesis& hypothesis : query.hypotheses)
      if (!named.insert(hypothesis.name).second)
        found.push_back(query.id + ": two hypotheses " + hypothesis.name);
    if (!query.is_false_by_definition) found.push_back(query.id + ": its models are not tested");
    Formula::Names names = names_in(query);
    for (const Unknown& unknown : query.unknowns) {
      std::size_t used = 0;
      for (const std::string& name : numbers_of(unknown)) used += names.numbers.erase(name);
      for (const std::string& name : flags_of(unknown)) used += names.flags.erase(name);
      if (used == 0) found.push_back(query.id + ": does not use " + unknown.name);
    }
    for (const std::string& name : names.numbers)
      found.push_back(query.id + ": does not declare " + name);
    for (const std::string& name : names.flags)
      found.push_back(query.id + ": does not declare " + name);
  }
  return found;
}

Formula formula_of(const Query& query, const Question& question, const Values& values) {
  std::vector<Formula> parts;
  for (const Condition& condition : assertions(query, question))
    parts.push_back(condition.in(values));
  return all_of(parts);
}

std::string smt_text(const Query& query, const Question& question, bool with_model) {
  std::ostringstream text;
  const std::vector<Condition> all = assertions(query, question);
  std::vector<Formula> formulas;
  for (const Condition& condition : all) formulas.push_back(condition.in(Values()));
  text << "; SPDX-License-Identifier: GPL-3.0-or-later\n; " << query.id << ", "
       << to_string(question) << ": expected to be "
       << (is_expected_satisfiable(question.asked) ? "sat" : "unsat") << '\n';
  if (with_model) text << "(set-option :produce-models true)\n";
  text << "(set-logic " << (all_of(formulas).degree() > 1 ? "QF_NRA" : "QF_LRA") << ")\n";
  std::string names;
  for (const Unknown& unknown : query.unknowns) {
    for (const std::string& name : numbers_of(unknown)) {
      text << "(declare-const " << name << " Real)\n";
      names += " " + name;
    }
    for (const std::string& name : flags_of(unknown)) {
      text << "(declare-const " << name << " Bool)\n";
      names += " " + name;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    text << "; " << all[i].says << "\n(assert " << formulas[i].to_smt() << ")\n";
  text << "(check-sat)\n";
  if (with_model) text << "(get-value (" << names.substr(1) << "))\n";
  return text.str();
}

}  // namespace oplus::smt
