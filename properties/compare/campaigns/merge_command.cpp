// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/campaigns/merge_command.hpp"
#include "checked/cli/command_line/terminal.hpp"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "checked/cli/command_line/terminal.hpp"
#include "properties/compare/campaigns/merged_report.hpp"
#include "properties/compare/conformance/report.hpp"
#include "properties/compare/sealed_report.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Settings {
  std::vector<std::string> reports;
  std::string into = "-";
  std::string out;
};

nlohmann::ordered_json read(const std::string& file) {
  return opened(text_of_file(file, "the report of a shard"), file);
}

int merge(const Settings& settings) {
  std::vector<std::pair<std::string, nlohmann::ordered_json>> reports;
  for (const std::string& file : settings.reports) reports.emplace_back(file, read(file));
  const nlohmann::ordered_json merged = merged_report(reports);
  const bool is_conformance = merged.at("report") == "conformance";
  if (!is_conformance && (settings.into.ends_with(".md") || settings.into.ends_with(".xml"))) {
    say_error(settings.into + ": reports of " + merged.at("report").get<std::string>() +
              " are JSON only");
    return 2;
  }
  std::string text = sealed(merged);
  if (is_conformance) {
    const ConformanceReport report = conformance_of_json(merged);
    text = conformance_text(report, settings.into);
    if (!settings.out.empty()) write_counterexamples(report, settings.out);
  }
  write_file(settings.into, text);
  return found_nothing(merged) ? 0 : 1;
}

}  // namespace

void add_merge_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "merge",
      "Make one report of those of all shards of a campaign: what one run would have written");
  const auto settings = std::make_shared<Settings>();
  command->add_option("reports", settings->reports, "The JSON reports of all shards, in any order")
      ->type_name("REPORT")
      ->required();
  command
      ->add_option("-o,--output", settings->into,
                   "The merged report; of conformance also .md and .xml; -: standard output")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--out", settings->out, "Of conformance: folder for the counterexamples")
      ->type_name("DIR");
  command->footer(
      "Example:\n"
      "  oplus-check merge shard-*.json -o conformance.json\n"
      "\n"
      "Exit codes:\n"
      "  0  all is as it should be\n"
      "  1  it is not\n"
      "  2  shards are missing, are there twice with different content, are of different campaigns,\n"
      "     or are damaged");
  command->callback([settings, &exit_code] { exit_code = merge(*settings); });
}

}  // namespace oplus
