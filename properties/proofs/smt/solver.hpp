// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "properties/proofs/smt/values.hpp"

namespace oplus::smt {

struct Solver {
  std::string name;
  std::vector<std::string> command;  ///< without the file
};

/// Z3 and cvc5, so that one checks the other.
const std::vector<Solver>& solvers();

/// The version that a solver prints. Throws std::system_error where it cannot be started.
std::string version_of(const Solver& solver);

struct Answer {
  enum class Kind { satisfiable, unsatisfiable, none };
  Kind kind = Kind::none;
  std::string why_none;        ///< what it printed instead, or that it took too long
  std::optional<Model> model;  ///< none if it was not asked for, or has an irrational number
};

std::string to_string(Answer::Kind kind);

/// Asks a solver about a file. Throws std::system_error where it cannot be started.
Answer ask(const Solver& solver, const std::string& file, double seconds);

/// The values that a solver prints: ((NAME VALUE) ...). Empty if a value is not rational. Throws
/// std::invalid_argument on anything else.
std::optional<Model> model_in(const std::string& text);

}  // namespace oplus::smt
