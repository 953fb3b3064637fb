// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/runner/mixture.hpp"
#include "properties/runner/statement.hpp"

namespace oplus {

/// All statements with their texts, in the order of their numbers, facts and laws last.
std::vector<Statement> statements();

/// Registers a statement before main, with sources and promises of its own or those of a mixture.
struct Registered {
  explicit Registered(Statement statement);
  Registered(Mixture pairs, Statement statement);
};

/// A source file, as the compiler names it, relative to the root.
std::string relative_file(const std::string& file);

/// The file of a statement, relative to the root.
std::string relative_file(const Statement& statement);

}  // namespace oplus
