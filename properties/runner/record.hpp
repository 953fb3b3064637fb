// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "properties/runner/property_run.hpp"

namespace oplus {

/// The outcome of a mutant with a statement that names it.
struct Kill {
  std::string mutant;
  std::string statement;
  bool killed = false;
  bool by_enumeration = false;  ///< which failed; no pair was tried
  std::size_t cases = 0;        ///< pairs tried, the one that failed counted
  std::string why = {};         ///< what was seen on the shrunk pair or in the enumeration
  /// Fails with the fault and holds without; no smaller one does.
  std::optional<Summands> shrunk = {};
  std::optional<Point> at = {};  ///< as `Outcome::at`
};

// JSON as docs/json.md describes it: what --json prints, --record writes, and docs/theorems/ keeps. Same
// seed, same program, same text. An object per line, regions as WKT.

/// Of `oplus-check properties`.
std::string to_json(const std::vector<PropertyRun>& runs);

/// Of `oplus-check properties --pair`: the outcome of each statement.
/// Requires: as many outcomes as statements.
std::string to_json(const std::vector<Statement>& statements, const std::vector<Outcome>& outcomes);

/// Of `oplus-maintain mutants`.
std::string to_json(const std::vector<Kill>& kills);

}  // namespace oplus
