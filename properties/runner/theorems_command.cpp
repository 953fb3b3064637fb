// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/commands.hpp"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "properties/mutants/mutants.hpp"
#include "properties/runner/known_name.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

struct Settings {
  std::string id;
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
    title_width = std::max(title_width, s.text.title.size());
  }
  for (const Statement& s : all) {
    std::cout << std::left << std::setw(static_cast<int>(id_width) + 2) << s.id
              << std::setw(static_cast<int>(title_width) + 2) << s.text.title << relative_file(s)
              << '\n'
              << std::string(id_width + 2, ' ') << "kills " << joined(s.kills) << '\n';
  }
  std::cout << all.size() << " statements, " << mutants().size() << " mutants\n";
}

/// As its page says; of a statement of which nothing is recorded yet, as its entry does.
std::string backing(const Statement& s) {
  if (!s.text.backing.empty()) return s.text.backing;
  return std::string(s.enumerate ? "proved by enumeration" : "") +
         (s.enumerate && s.check ? "; " : "") + (s.check ? "sampled" : "");
}

std::string page(const Statement& s) { return "docs/theorems/" + s.id + ".md"; }

void print_entry(const Statement& s) {
  std::cout << s.id << ": " << s.text.title << "\n\nStatement. " << s.text.statement << "\n\nWhy. "
            << s.text.why << "\n\nHypotheses: " << joined(s.text.hypotheses, "; ")
            << "\nRests on: " << joined(s.text.rests_on) << "\nKills: " << joined(s.kills)
            << "\nBacked by: " << backing(s) << "\nCases: " << s.cases << (s.check ? ", from" : "");
  for (const Source& source : s.sources)
    std::cout << ' ' << source.family << " (n to " << source.largest << ", weight " << source.weight
              << ')';
  std::vector<std::string> promises;
  for (const Promise& promise : s.promises)
    promises.push_back(promise.classification + " in " + std::to_string(promise.percent) + " %");
  std::cout << "\nPromises: " << joined(promises) << "\nFile: " << relative_file(s)
            << "\nPage: " << page(s) << '\n';
}

nlohmann::ordered_json json_of(const Statement& s) {
  nlohmann::ordered_json sources = nlohmann::ordered_json::array();
  for (const Source& source : s.sources)
    sources.push_back(
        {{"family", source.family}, {"largest", source.largest}, {"weight", source.weight}});
  nlohmann::ordered_json promises = nlohmann::ordered_json::object();
  for (const Promise& promise : s.promises) promises[promise.classification] = promise.percent;
  return {{"statement", s.id},
          {"title", s.text.title},
          {"kind", s.kind()},
          {"says", s.text.statement},
          {"why", s.text.why},
          {"hypotheses", s.text.hypotheses},
          {"rests_on", s.text.rests_on},
          {"kills", s.kills},
          {"enumerated", s.enumerate != nullptr},
          {"cases", s.cases},
          {"sources", sources},
          {"promised_percent", promises},
          {"file", relative_file(s)},
          {"backing", backing(s)},
          {"page", page(s)}};
}

nlohmann::ordered_json json_of(const std::vector<Statement>& all) {
  nlohmann::ordered_json report = {{"statements", nlohmann::ordered_json::array()},
                                   {"mutants", nlohmann::ordered_json::array()}};
  for (const Statement& s : all) report["statements"].push_back(json_of(s));
  for (const Mutant& mutant : mutants())
    report["mutants"].push_back(
        {{"mutant", mutant.name}, {"what", mutant.what}, {"file", mutant.file}});
  return report;
}

int theorems(const Settings& settings) {
  const std::vector<Statement> all = statements();
  if (settings.id.empty()) {
    if (settings.json)
      std::cout << json_of(all).dump(2) << '\n';
    else
      print_table(all);
  } else {
    const Statement& one = *std::ranges::find(all, settings.id, &Statement::id);
    if (settings.json)
      std::cout << json_of(one).dump(2) << '\n';
    else
      print_entry(one);
  }
  return 0;
}

}  // namespace

void add_theorems_command(Program& program) {
  const std::vector<std::string> ids = texts(statements(), &Statement::id);
  const auto& [command, settings] = program.add(
      "theorems", "List the statements and the faults that each must find, or show one", theorems);
  command.option("ID NAME", settings.id, "Show all about this statement; default: a list of all")
      .one_of(ids, known_name("statement", ids, "'oplus-check theorems' lists all"));
  command.flag("--json", settings.json, "Answer in JSON (docs/json.md)");
  command.footer(
      "Example:\n"
      "  oplus-check theorems theorem-4.2.1\n"
      "\n"
      "Exit codes:\n"
      "  0  listed\n"
      "  2  invalid usage");
}

}  // namespace oplus
