// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/registry_with_records.hpp"

#include <set>

#include "properties/pages/links.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/file_text.hpp"

namespace oplus {

namespace fs = std::filesystem;

Registry registry_with_records(const RecordFolders& folders) {
  Registry registry{statements(), mutants(), {}, {}};
  const fs::path runs = folders.docs / "theorems/runs.json",
                 kills = folders.docs / "theorems/kills.json";
  for (PropertyRun& run : runs_of_json(text_of_file(runs, "a record of runs"), runs.string()))
    registry.runs[run.statement] = std::move(run);
  registry.kills = kills_of_json(text_of_file(kills, "a record of kills"), kills.string());
  registry.theorems = proved_theorems(folders.proofs);
  registry.queries = answered_queries(folders.smt);
  registry.citing = citing_pages(folders.docs);
  registry.findings = headings_of(text_of_file(folders.docs / "findings.md", "the findings"));
  return registry;
}

std::vector<std::string> defects_of_records(const Registry& registry) {
  std::vector<std::string> defects;
  std::set<std::string> ids;
  std::set<std::pair<std::string, std::string>> named, recorded;
  for (const Kill& kill : registry.kills) {
    recorded.emplace(kill.statement, kill.mutant);
    if (!kill.killed) defects.push_back(kill.statement + ": has not killed " + kill.mutant);
  }
  for (const Statement& s : registry.statements) {
    ids.insert(s.id);
    if (!registry.runs.contains(s.id)) defects.push_back(s.id + ": no run is recorded");
    for (const std::string& mutant : s.kills) {
      named.emplace(s.id, mutant);
      if (!recorded.contains({s.id, mutant}))
        defects.push_back(s.id + ": no kill of " + mutant + " is recorded");
    }
    for (const std::string& name : missing_findings(s.statement + " " + s.why, registry.findings))
      defects.push_back(s.id + ": docs/findings.md has no heading with " + name);
  }
  for (const auto& [id, run] : registry.runs) {
    if (!ids.contains(id))
      defects.push_back(id + ": a run is recorded, but there is no such statement");
    if (!run.passed()) defects.push_back(id + ": the recorded run has not passed");
  }
  for (const auto& [id, mutant] : recorded)
    if (!named.contains({id, mutant}))
      defects.push_back(id + ": a kill of " + mutant + " is recorded, which it does not name");
  for (const ProvedTheorem& theorem : registry.theorems)
    if (!ids.contains(theorem.statement))
      defects.push_back(theorem.name + ": is to back " + theorem.statement +
                        ", but there is no such statement");
  for (const AnsweredQuery& query : registry.queries)
    if (!ids.contains(query.statement))
      defects.push_back(query.id + ": is to back " + query.statement +
                        ", but there is no such statement");
  for (const auto& [id, pages] : registry.citing)
    if (!ids.contains(id))
      defects.push_back("docs/" + pages.front() + ".md: links to " + id +
                        ", but there is no such statement");
  return defects;
}

}  // namespace oplus
