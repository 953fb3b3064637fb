// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/commands.hpp"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "properties/pages/registry_with_records.hpp"
#include "properties/pages/statement_graph.hpp"
#include "properties/pages/strength.hpp"
#include "properties/runner/known_name.hpp"
#include "properties/runner/registry.hpp"
#include "properties/runner/source_tree.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

struct Settings {
  std::string id;
  bool check = false;
  bool json = false;
};

std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ") {
  return words.empty() ? "none" : boost::algorithm::join(words, separator);
}

/// Ids and titles are ASCII, so that widths count characters.
void print_table(const std::vector<Statement>& all) {
  std::size_t id_width = 0, title_width = 0;
  for (const Statement& s : all) {
    id_width = std::max(id_width, s.id.size());
    title_width = std::max(title_width, s.title.size());
  }
  for (const Statement& s : all) {
    std::cout << std::left << std::setw(static_cast<int>(id_width) + 2) << s.id
              << std::setw(static_cast<int>(title_width) + 2) << s.title << relative_file(s) << '\n'
              << std::string(id_width + 2, ' ') << "kills " << joined(s.kills) << '\n';
  }
  std::cout << all.size() << " statements, " << mutants().size() << " mutants\n";
}

/// Those of the sources; nullopt where they are not installed.
std::optional<Registry> records() {
  try {
    return registry_with_records({source_root() / "docs", source_root() / "properties/proofs",
                                  source_root() / "properties/proofs/smt"});
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

/// As its page says; without the records, as its entry does.
std::string backing(const Statement& s, const std::optional<Registry>& records) {
  if (records) return backing(*records, s);
  return std::string(s.enumerate ? "proved by enumeration" : "") +
         (s.enumerate && s.check ? "; " : "") + (s.check ? "sampled" : "");
}

std::string page(const Statement& s) { return "docs/theorems/" + s.id + ".md"; }

void print_entry(const Statement& s) {
  std::cout << s.id << ": " << s.title << "\n\nStatement. " << s.statement << "\n\nWhy. " << s.why
            << "\n\nHypotheses: " << joined(s.hypotheses, "; ")
            << "\nRests on: " << joined(s.rests_on) << "\nKills: " << joined(s.kills)
            << "\nBacked by: " << backing(s, records()) << "\nCases: " << s.cases
            << (s.check ? ", from" : "");
  for (const Source& source : s.sources)
    std::cout << ' ' << source.family << " (n to " << source.largest << ", weight " << source.weight
              << ')';
  std::vector<std::string> promises;
  for (const Promise& promise : s.promises)
    promises.push_back(promise.classification + " in " + std::to_string(promise.percent) + " %");
  std::cout << "\nPromises: " << joined(promises) << "\nFile: " << relative_file(s)
            << "\nPage: " << page(s) << '\n';
}

nlohmann::ordered_json json_of(const Statement& s, const std::optional<Registry>& records) {
  nlohmann::ordered_json sources = nlohmann::ordered_json::array();
  for (const Source& source : s.sources)
    sources.push_back(
        {{"family", source.family}, {"largest", source.largest}, {"weight", source.weight}});
  nlohmann::ordered_json promises = nlohmann::ordered_json::object();
  for (const Promise& promise : s.promises) promises[promise.classification] = promise.percent;
  return {{"statement", s.id},
          {"title", s.title},
          {"kind", s.kind()},
          {"says", s.statement},
          {"why", s.why},
          {"hypotheses", s.hypotheses},
          {"rests_on", s.rests_on},
          {"kills", s.kills},
          {"enumerated", s.enumerate != nullptr},
          {"cases", s.cases},
          {"sources", sources},
          {"promised_percent", promises},
          {"file", relative_file(s)},
          {"backing", backing(s, records)},
          {"page", page(s)}};
}

nlohmann::ordered_json json_of(const std::vector<Statement>& all) {
  nlohmann::ordered_json report = {{"statements", nlohmann::ordered_json::array()},
                                   {"mutants", nlohmann::ordered_json::array()}};
  const std::optional<Registry> recorded = records();
  for (const Statement& s : all) report["statements"].push_back(json_of(s, recorded));
  for (const Mutant& mutant : mutants())
    report["mutants"].push_back({{"mutant", mutant.name}, {"what", mutant.what}});
  return report;
}

bool check(const std::vector<Statement>& all, bool in_json) {
  std::vector<std::string> defects = defects_of_entries(all, mutants());
  for (std::string& d : defects_of_files(all, source_root())) defects.push_back(std::move(d));
  for (std::string& d : defects_of_graph(all)) defects.push_back(std::move(d));
  if (in_json) {
    std::cout << nlohmann::ordered_json({{"statements", all.size()},
                                         {"mutants", mutants().size()},
                                         {"defects", defects}})
                     .dump(2)
              << '\n';
    return defects.empty();
  }
  for (const std::string& d : defects) std::cout << d << '\n';
  std::cout << all.size() << " statements, " << mutants().size() << " mutants, " << defects.size()
            << " defects\n";
  return defects.empty();
}

int theorems(const Settings& settings) {
  const std::vector<Statement> all = statements();
  if (settings.check) return check(all, settings.json) ? 0 : 1;
  if (settings.id.empty()) {
    if (settings.json)
      std::cout << json_of(all).dump(2) << '\n';
    else
      print_table(all);
  } else {
    const Statement& one = *std::ranges::find(all, settings.id, &Statement::id);
    if (settings.json)
      std::cout << json_of(one, records()).dump(2) << '\n';
    else
      print_entry(one);
  }
  return 0;
}

}  // namespace

void add_theorems_command(Program& program) {
  const auto& [command, settings] = program.add(
      "theorems", "List the statements and the faults that each must find, or show one", theorems);
  const Option id =
      command.option("ID", settings.id, "Show all about this statement; default: a list of all")
          .type("NAME")
          .one_of(known_name("statement", texts(statements(), &Statement::id),
                             "'oplus-check theorems' lists all"));
  command.flag("--check", settings.check, "Fail if the list differs from the sources").excludes(id);
  command.flag("--json", settings.json, "Answer in JSON (docs/json.md)");
  command.footer(
      "Example:\n"
      "  oplus-check theorems theorem-4.2.1\n"
      "\n"
      "Exit codes:\n"
      "  0  listed; of oplus-maintain theorems --check: the list agrees with the sources\n"
      "  1  of --check: it does not\n"
      "  2  invalid usage");
}

}  // namespace oplus
