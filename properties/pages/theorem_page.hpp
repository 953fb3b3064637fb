// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "properties/mutants/mutants.hpp"
#include "properties/runner/record.hpp"

namespace oplus {

/// All that pages are made of. Everything in it is the registry's or was recorded.
struct Registry {
  std::vector<Statement> statements;
  std::vector<Mutant> mutants;
  std::map<std::string, RecordedRun> runs;  ///< by statement
  std::vector<Kill> kills;
};

/// A file below docs/, by its path from there.
struct Page {
  std::string path;
  std::string text;
};

/// Returns "enumerated, 1000 cases", "sampled, 1500 pairs", or both.
std::string backing(const RecordedRun& run);

/// The mutant's entry. Requires: there is one.
const Mutant& mutant_of(const Registry& registry, const std::string& name);

/// docs/theorems/ID.md and its pictures of a typical and of a shrunk case.
std::vector<Page> theorem_pages(const Registry& registry, const Statement& statement);

}  // namespace oplus
