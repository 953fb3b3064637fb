// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "properties/proofs/smt/query.hpp"
#include "properties/proofs/smt/solver.hpp"

namespace oplus::smt {

/// The result of one solver for one question.
struct Asking {
  std::string solver;
  Question question;
  Answer answer;
  double seconds;
};

struct QueryRun {
  std::string id;
  std::vector<Asking> askings;
  std::vector<std::string> failures;  ///< in words; empty where all is as expected
};

/// Writes the questions of a query, ID.proof.smt2 and so on, into a folder that exists.
void write_questions(const Query& query, const std::filesystem::path& folder);

/// Asks all solvers all of them. A failure is
///  1. an answer other than the expected one, or no answer, or none in time;
///  2. a model that does not satisfy the formulas, or the code from which they were made when it runs
///  on the model's numbers; both exactly;
///  3. a model of a twin that is not a counterexample by the definitions.
QueryRun run(const Query& query, const std::filesystem::path& folder, double seconds);

}  // namespace oplus::smt
