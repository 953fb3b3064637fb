// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/runner/kill.hpp"

namespace oplus {

// JSON as docs/json.md describes it: what --json prints, --record writes, and docs/theorems/ keeps. Same
// seed, same program, same text. An object per line, regions as WKT.

/// Of `oplus-check properties`.
std::string to_json(const std::vector<PropertyRun>& runs);

/// Of `oplus-check properties --pair`: what each statement says of the pair.
/// Requires: as many outcomes as statements.
std::string to_json(const std::vector<Statement>& statements, const std::vector<Outcome>& outcomes);

/// Of `oplus-maintain mutants`. `defects`: of the list of mutants.
std::string to_json(const std::vector<Kill>& kills, const std::vector<std::string>& defects);

/// Read runs and kills back, without counterexamples. Throw InvalidInput; `file` is what messages call
/// the text.
std::vector<PropertyRun> runs_of_json(const std::string& text, const std::string& file);
std::vector<Kill> kills_of_json(const std::string& text, const std::string& file);

}  // namespace oplus
