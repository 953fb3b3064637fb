// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/pages_commands.hpp"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "properties/pages/statement_graph.hpp"
#include "properties/runner/registry.hpp"
#include "properties/runner/source_tree.hpp"

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

std::string backing(const Statement& s) {
  return !s.enumerate ? "pairs" : s.check ? "an enumeration, and pairs" : "an enumeration";
}

void print_entry(const Statement& s) {
  std::cout << s.id << ": " << s.title << "\n\nStatement. " << s.statement << "\n\nWhy. " << s.why
            << "\n\nHypotheses: " << joined(s.hypotheses, "; ")
            << "\nRests on: " << joined(s.rests_on) << "\nKills: " << joined(s.kills)
            << "\nBacked by " << backing(s) << "\nCases: " << s.cases << (s.check ? ", from" : "");
  for (const Source& source : s.sources)
    std::cout << ' ' << source.family << " (n to " << source.largest << ", weight " << source.weight
              << ')';
  std::vector<std::string> promises;
  for (const Promise& promise : s.promises)
    promises.push_back(promise.classification + " in " + std::to_string(promise.percent) + " %");
  std::cout << "\nPromises: " << joined(promises) << "\nFile: " << relative_file(s) << '\n';
}

nlohmann::ordered_json json_of(const Statement& s) {
  nlohmann::ordered_json sources = nlohmann::ordered_json::array();
  for (const Source& source : s.sources)
    sources.push_back(
        {{"family", source.family}, {"largest", source.largest}, {"weight", source.weight}});
  nlohmann::ordered_json promises = nlohmann::ordered_json::object();
  for (const Promise& promise : s.promises) promises[promise.classification] = promise.percent;
  return {{"statement", s.id},       {"title", s.title},   {"kind", s.kind()},
          {"says", s.statement},     {"why", s.why},       {"hypotheses", s.hypotheses},
          {"rests_on", s.rests_on},  {"kills", s.kills},   {"enumerated", s.enumerate != nullptr},
          {"cases", s.cases},        {"sources", sources}, {"promised_percent", promises},
          {"file", relative_file(s)}};
}

nlohmann::ordered_json json_of(const std::vector<Statement>& all) {
  nlohmann::ordered_json report = {{"statements", nlohmann::ordered_json::array()},
                                   {"mutants", nlohmann::ordered_json::array()}};
  for (const Statement& s : all) report["statements"].push_back(json_of(s));
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

}  // namespace

void add_theorems_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "theorems", "List the statements and the faults that each must find, or show one");
  const auto settings = std::make_shared<Settings>();
  std::vector<std::string> ids;
  for (const Statement& s : statements()) ids.push_back(s.id);
  CLI::Option* id =
      command
          ->add_option("ID", settings->id,
                       "Show all that is known of this statement; without it: the list")
          ->type_name("NAME")
          ->check(CLI::IsMember(ids));
  command->add_flag("--check", settings->check, "Fail where the list does not fit the sources")
      ->excludes(id);
  command->add_flag("--json", settings->json, "Answer in JSON (docs/json.md)");
  command->footer(
      "Example:\n"
      "  oplus-check theorems theorem-4.2.1\n"
      "\n"
      "Exit codes:\n"
      "  0  listed; of oplus-maintain theorems --check: the list fits the sources\n"
      "  1  of that: it does not\n"
      "  2  the request makes no sense");
  command->callback([settings, &exit_code] {
    const std::vector<Statement> all = statements();
    if (settings->check) {
      exit_code = check(all, settings->json) ? 0 : 1;
    } else if (settings->id.empty()) {
      if (settings->json)
        std::cout << json_of(all).dump(2) << '\n';
      else
        print_table(all);
    } else {
      const Statement& one = *std::ranges::find(all, settings->id, &Statement::id);
      if (settings->json)
        std::cout << json_of(one).dump(2) << '\n';
      else
        print_entry(one);
    }
  });
}

}  // namespace oplus
