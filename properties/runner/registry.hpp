// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "properties/mutants/mutants.hpp"
#include "properties/runner/statement.hpp"

namespace oplus {

/// All statements, in the order of their numbers, facts and laws last.
std::vector<Statement> statements();

/// Registers a statement before main.
struct Registered {
  explicit Registered(Statement statement);
};

/// A source file, as the compiler names it, relative to the root.
std::string relative_file(const std::string& file);

/// The file of a statement, relative to the root.
std::string relative_file(const Statement& statement);

/// What is wrong with the entries themselves, a line each; empty if:
///  1. ids are unique and start with their kind;
///  2. each statement has a text, and a check or an enumeration; with a check, sources that are
///  families, classes that exist, and a number of cases; without, none of these;
///  3. each statement names at least one mutant, and each mutant exists;
///  4. mutants have unique names, and each is named by a statement.
std::vector<std::string> defects_of_entries(const std::vector<Statement>& statements,
                                            const std::vector<Mutant>& mutants);

/// What is wrong between entries and source files, a line each; empty if:
///  1. the file of each statement exists;
///  2. each KIND_*.cpp below properties/statements/ is the file of a statement;
///  3. each statement has its page docs/theorems/ID.md.
std::vector<std::string> defects_of_files(const std::vector<Statement>& statements,
                                          const std::filesystem::path& root);

}  // namespace oplus
