// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "properties/mutants/mutants.hpp"
#include "properties/pages/proof_record.hpp"
#include "properties/runner/record.hpp"

namespace oplus {

/// Everything from which pages are made: the registry, the records, and what other pages say.
struct Registry {
  std::vector<Statement> statements;
  std::vector<Mutant> mutants;
  std::map<std::string, PropertyRun> runs;  ///< by statement
  std::vector<Kill> kills;
  std::vector<ProvedTheorem> theorems = {};
  std::vector<AnsweredQuery> queries = {};
  std::map<std::string, std::vector<std::string>> citing = {};  ///< as `citing_pages`
  std::vector<std::string> findings = {};                       ///< headings of docs/findings.md
};

/// Where records are.
struct RecordFolders {
  std::filesystem::path docs;    ///< theorems/runs.json and kills.json; pages that cite statements
  std::filesystem::path proofs;  ///< theorems.json
  std::filesystem::path smt;     ///< results.json
};

/// Throws InvalidInput where one cannot be read.
Registry registry_with_records(const RecordFolders& folders);

/// What is missing in the records or does not fit the registry any more, a line each: a statement
/// without a run that passed, a mutant that a statement names without a kill, a record, theorem or
/// query of an unknown statement, a section of docs/findings.md that a statement names and that
/// does not exist.
std::vector<std::string> defects_of_records(const Registry& registry);

}  // namespace oplus
