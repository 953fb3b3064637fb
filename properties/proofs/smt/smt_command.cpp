// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/commands.hpp"

#include <algorithm>
#include <iostream>
#include <optional>
#include <set>

#include "checked/cli/command_line/terminal.hpp"
#include "properties/proofs/smt/report.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Settings {
  std::vector<std::string> names;
  bool lists = false;
  bool only_writes = false;
  bool json = false;
  std::string folder;
  std::string record;
  std::string mutant;
  double seconds = 60;
};

std::vector<smt::Query> chosen(const std::vector<std::string>& names) {
  std::vector<smt::Query> all = smt::queries();
  std::erase_if(all, [&](const smt::Query& query) {
    return !names.empty() && std::none_of(names.begin(), names.end(), [&](const std::string& name) {
      return name == query.id || name == query.statement();
    });
  });
  return all;
}

std::vector<std::string> names_to_choose() {
  std::set<std::string> names;
  for (const smt::Query& query : smt::queries()) names.insert({query.id, query.statement()});
  return {names.begin(), names.end()};
}

int list(const Settings& settings, const std::vector<smt::Query>& queries) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const smt::Query& query : queries) {
    json.push_back(to_json(query));
    text_output(settings.json) << query.id << ": " << query.conclusion.says << '\n';
  }
  if (settings.json) std::cout << nlohmann::ordered_json{{"queries", json}}.dump(2) << '\n';
  return 0;
}

int prove(const Settings& settings, const std::vector<smt::Query>& queries) {
  const std::vector<std::string> defects = smt::defects_of_queries(queries);
  for (const std::string& defect : defects) say_error(defect);
  std::optional<TemporaryFolder> temporary;
  std::filesystem::path folder = settings.folder;
  if (folder.empty())
    folder = temporary.emplace("oplus-smt").path();
  else
    std::filesystem::create_directories(folder);
  for (const smt::Query& query : queries) write_questions(query, folder);
  if (settings.only_writes) return defects.empty() ? 0 : 1;
  std::ostream& out = text_output(settings.json);
  for (const smt::Solver& solver : smt::solvers()) out << version_of(solver) << '\n';
  std::vector<smt::QueryRun> runs;
  std::size_t failed = 0;
  for (const smt::Query& query : queries) {
    runs.push_back(run(query, folder, settings.seconds));
    out << line_of(runs.back()) << std::endl;
    for (const std::string& failure : runs.back().failures) out << "  " << failure << '\n';
    if (!runs.back().failures.empty()) ++failed;
  }
  const bool is_good = failed == 0 && defects.empty() && !queries.empty();
  const std::string verdict =
      counted(runs.size(), "query", "queries") + ", " + std::to_string(failed) + " failed\n";
  out << with_painted_verdict(verdict, is_good ? Paint::good : Paint::bad, out);
  const std::string record = record_of(queries, runs).dump(2) + "\n";
  if (settings.json) std::cout << record;
  if (!settings.record.empty()) write_file(settings.record, record);
  return is_good ? 0 : 1;
}

int smt_work(const Settings& settings) {
  if (!settings.mutant.empty()) {
#ifdef OPLUS_MUTANTS
    active_mutant = settings.mutant;
#else
    say_error("faults are in the preset check only");
    return 2;
#endif
  }
  const std::vector<smt::Query> queries = chosen(settings.names);
  return settings.lists ? list(settings, queries) : prove(settings, queries);
}

}  // namespace

void add_smt_command(Program& program) {
  const auto& [command, settings] =
      program.add("smt", "Prove statements about a few directions with Z3 and cvc5", smt_work);
  command
      .option("name ID", settings.names,
              "Queries, or statements, each standing for all its queries")
      .one_of(names_to_choose());
  command.flag("--list", settings.lists, "List the queries, without running a solver");
  const Option kept = command.option("--write DIR", settings.folder,
                                     "Keep the questions, SMT-LIB files, in this folder");
  command.flag("--only-write", settings.only_writes, "Write them, without running a solver")
      .needs(kept);
  command.option("--seconds", settings.seconds, "Time limit of a solver for each question")
      .range(0.01, 1e6)
      .default_shown();
  command.option("--record FILE", settings.record, "Write what --json prints to this file");
  command.option("--mutant NAME", settings.mutant, "Switch this fault on; preset check only");
  command.flag("--json", settings.json, "Print the result, or the list, as JSON (docs/json.md)");
  command.footer(
      "Example:\n"
      "  oplus-check smt table-4.3-to-4.6 --write questions\n"
      "\n"
      "Exit codes:\n"
      "  0  both solvers gave every expected answer\n"
      "  1  an unexpected answer, no answer, or none in time; a model that is not a counterexample\n"
      "  2  invalid usage, or a solver is missing");
}

}  // namespace oplus
