// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "checked/cli/usage_error.hpp"
#include "properties/compare/compare_commands.hpp"
#include "properties/compare/counterexample_files.hpp"
#include "properties/compare/report_json.hpp"
#include "properties/compare/report_text.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Settings {
  std::vector<std::string> reports;
  std::string into = "-";
  std::string out;
};

int merge(const Settings& settings) {
  std::vector<std::pair<std::string, CampaignReport>> reports;
  for (const std::string& file : settings.reports)
    reports.emplace_back(file, opened(text_of_file(file, "the report of a shard"), file));
  const CampaignReport report = merged(reports);
  if (!settings.out.empty()) write_counterexamples(report, settings.out);
  write_file(settings.into, report_text(report, settings.into));
  if (!report.conforms()) return 1;
  if (report.compared_nothing()) throw UsageError(report.report + " compared nothing");
  return 0;
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
                   "The merged report: .md, .xml, else JSON; -: standard output")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--out", settings->out, "Folder for the counterexamples")->type_name("DIR");
  command->footer(
      "Example:\n"
      "  oplus-check merge shard-*.json -o conformance.json\n"
      "\n"
      "Exit codes:\n"
      "  0  all is as it should be\n"
      "  1  it is not\n"
      "  2  nothing was compared; shards are missing, are there twice with different content, are of\n"
      "     different campaigns, or are damaged");
  command->callback([settings, &exit_code] { exit_code = merge(*settings); });
}

}  // namespace oplus
