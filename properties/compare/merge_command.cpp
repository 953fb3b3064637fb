// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/usage_error.hpp"
#include "properties/commands.hpp"
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
  CampaignReport report = merged(reports);
  if (!settings.out.empty()) {
    report.out = settings.out;
    write_counterexamples(report);
  }
  write_file(settings.into, report_text(report, settings.into));
  if (!report.conforms()) return 1;
  if (report.compared_nothing()) throw UsageError(report.report + " compared nothing");
  return 0;
}

}  // namespace

void add_merge_command(Program& program) {
  const auto& [command, settings] = program.add(
      "merge",
      "Merge the reports of all shards of a campaign into the one that a single run would have written",
      merge);
  command.option("reports REPORT", settings.reports, "The JSON reports of all shards, in any order")
      .required();
  command
      .option("-o,--output FILE", settings.into,
              "The merged report: .md, .xml, else JSON; -: standard output")
      .default_shown();
  command.option(
      "--out DIR", settings.out,
      "Write the counterexamples to this folder; default: they stay in the first shard's");
  command.footer(
      "Example:\n"
      "  oplus-check merge shard-*.json -o conformance.json\n"
      "\n"
      "Exit codes:\n"
      "  0  no disagreement\n"
      "  1  a disagreement\n"
      "  2  nothing was compared; or reports are missing, damaged, interrupted, of different campaigns,\n"
      "     or of the same shard with different content");
}

}  // namespace oplus
