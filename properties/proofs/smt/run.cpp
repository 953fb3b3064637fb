// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/run.hpp"

#include <chrono>
#include <exception>

#include "reference/io/writing.hpp"

namespace oplus::smt {

namespace {

std::filesystem::path file_of(const Query& query, const Question& question,
                              const std::filesystem::path& folder) {
  return folder / (query.id + "." + to_string(question) + ".smt2");
}

/// A broken contract is one, too.
std::string defect_by_definition(const Query& query, const Model& model) {
  try {
    if (query.is_false_by_definition(model)) return "";
    return "by the definitions the model is not a counterexample";
  } catch (const std::exception& error) {
    return std::string("by the definitions: ") + error.what();
  }
}

/// What is wrong with an answer; empty if nothing is.
std::string defect(const Query& query, const Question& question, const Answer& answer) {
  const bool is_satisfiable = is_expected_satisfiable(question.asked);
  const auto expected = is_satisfiable ? Answer::Kind::satisfiable : Answer::Kind::unsatisfiable;
  if (answer.kind == Answer::Kind::none) return "no answer: " + answer.why_none;
  if (answer.kind != expected)
    return "is " + to_string(answer.kind) + ", and was expected to be " + to_string(expected);
  if (!is_satisfiable) return "";
  if (!answer.model) return "the model has a number that is not rational";
  if (!formula_of(query, question, Values()).holds_in(*answer.model))
    return "the model does not satisfy the formulas";
  if (formula_of(query, question, Values(*answer.model)).value() != true)
    return "the code, run on the model's numbers, does not agree with its formulas";
  return question.asked == Asked::twin ? defect_by_definition(query, *answer.model) : "";
}

}  // namespace

void write_questions(const Query& query, const std::filesystem::path& folder) {
  for (const Question& question : questions(query))
    write_file(file_of(query, question, folder).string(),
               smt_text(query, question, is_expected_satisfiable(question.asked)));
}

QueryRun run(const Query& query, const std::filesystem::path& folder, double seconds) {
  QueryRun result{query.id, {}, {}};
  for (const Question& question : questions(query)) {
    for (const Solver& solver : solvers()) {
      const std::string file = file_of(query, question, folder).string();
      const auto start = std::chrono::steady_clock::now();
      const Answer answer = ask(solver, file, seconds);
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      result.askings.push_back({solver.name, question, answer, taken.count()});
      const std::string wrong = defect(query, question, answer);
      if (!wrong.empty())
        result.failures.push_back(query.id + ", " + to_string(question) + ", " + solver.name +
                                  ": " + wrong);
    }
  }
  return result;
}

}  // namespace oplus::smt
