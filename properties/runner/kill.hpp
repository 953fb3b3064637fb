// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "properties/mutants/mutants.hpp"
#include "properties/runner/property_run.hpp"

namespace oplus {

/// What became of a mutant under a statement that names it.
struct Kill {
  std::string mutant;
  std::string statement;
  bool killed = false;
  bool by_enumeration = false;  ///< which failed; no pair was tried
  std::size_t cases = 0;        ///< pairs tried, the one that failed counted
  std::string why = {};         ///< what was seen on the shrunk pair or in the enumeration
  std::optional<Summands> shrunk =
      {};  ///< fails with the fault and holds without; no smaller one does
};

/// Runs the statement with the fault switched on. It kills the mutant if its enumeration fails with
/// the fault and holds without, or if it fails on a pair with the fault and holds on the same pair
/// without. A run that is short or misses a share kills nothing.
/// Requires: a build with OPLUS_MUTANTS.
Kill try_to_kill(const Statement& statement, const Mutant& mutant, RunOptions options);

/// Returns a line that says so.
std::string in_words(const Kill& kill);

}  // namespace oplus
