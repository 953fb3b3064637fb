// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <source_location>
#include <string>
#include <vector>

#include "properties/proofs/smt/claim.hpp"

namespace oplus::smt {

/// A condition on unknowns, in words and as a formula.
struct Condition {
  std::string says;
  Claim claim;

  /// The same, made only once of the unknowns themselves.
  Formula in(const Values& values) const;

  std::shared_ptr<std::optional<Formula>> of_unknowns = std::make_shared<std::optional<Formula>>();
};

/// A hypothesis, and what is asked of its twin, the question that drops it: without any of its
/// hypotheses a query has a counterexample.
struct Hypothesis {
  std::string name;
  Condition condition;
  /// Additional conditions on the counterexample: so that regions can be built from it, or that the
  /// solvers find one soon.
  std::vector<Condition> of_twin = {};
};

/// "For all real numbers: if the hypotheses hold, so does the conclusion."
struct Query {
  std::string id;  ///< the id of the statement that it backs, a dot, and what it is about
  std::vector<Unknown> unknowns;
  std::vector<Hypothesis> hypotheses;
  Condition conclusion;
  /// One of the cases in which the solvers prove the statement, as they cannot prove all at once. Asserted
  /// in all questions; the conclusion holds without it, too, so it is no hypothesis and has no twin.
  std::vector<Condition> in_case = {};
  std::string file = std::source_location::current().file_name();  ///< where it stands
  /// Whether the definitions (reference/) say, too, that in this model the conclusion is false: of
  /// regions that are built from it, or of the code itself on its rational numbers.
  std::function<bool(const Model&)> is_false_by_definition;

  std::string statement() const { return id.substr(0, id.rfind('.')); }
};

/// The kinds of questions to a solver about a query.
enum class Asked {
  proof,       ///< hypotheses and not the conclusion: expected to be unsatisfiable
  hypotheses,  ///< the hypotheses alone: expected to be satisfiable, or the proof would be empty
  twin,        ///< all hypotheses but one, and not the conclusion: expected to be satisfiable
};

bool is_expected_satisfiable(Asked asked);

struct Question {
  Asked asked;
  std::string dropped = {};  ///< the name of the hypothesis, of a twin
};

/// "proof", "hypotheses" or "twin-NAME".
std::string to_string(const Question& question);

/// The proof, the hypotheses, and a twin for each of them.
std::vector<Question> questions(const Query& query);

/// In the order of their statements.
const std::vector<Query>& queries();

/// Registers the queries of a file before main.
struct RegisteredQueries {
  explicit RegisteredQueries(const std::vector<Query>& all);
};

/// What is wrong with queries, a line each: a statement that is not registered, no hypothesis, two of
/// the same name, unknowns that are declared and not used or used and not declared, an id used twice.
std::vector<std::string> defects_of_queries(const std::vector<Query>& all);

/// The conditions on a model, as one formula.
Formula formula_of(const Query& query, const Question& question, const Values& values);

/// The SMT-LIB 2.6 text of a question, with its models asked for where `with_model`.
std::string smt_text(const Query& query, const Question& question, bool with_model);

}  // namespace oplus::smt
