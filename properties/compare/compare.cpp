// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/compare.hpp"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <filesystem>
#include <iostream>
#include <thread>

#include "checked/arrangement/hole_test.hpp"
#include "checked/cli/batch/interrupted.hpp"
#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/output.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/engines/engines.hpp"
#include "properties/compare/certified_engine.hpp"
#include "properties/compare/counterexample_files.hpp"
#include "properties/compare/engine_called.hpp"
#include "properties/compare/operation.hpp"
#include "properties/compare/report_json.hpp"
#include "properties/compare/report_text.hpp"
#include "properties/compare/run_campaign.hpp"
#include "properties/compare/sources.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/known_name.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::vector<std::string> engine_names() {
  std::vector<std::string> names = {"all"};
  for (const std::vector<Engine>& some : {engines(), peers()})
    for (const Engine& engine : some) names.push_back(engine.name);
  names.insert(names.end(), {"certified", "proved"});
  return names;
}

HoleTestMethod hole_test_named(const std::string& name) {
  for (const auto& [known, method] : hole_test_methods())
    if (known == name) return method;
  return all_hole_tests();
}

/// Above that, a proved sum takes longer than all others together.
constexpr std::size_t most_proved_segments = 1000;

/// The engines that were named; where none was, all of oplus, and "certified" and, for small pairs, "proved" if they can
/// run.
std::vector<Engine> chosen_engines(const Campaign& campaign) {
  std::vector<Engine> chosen = checked_engines(hole_test_named(campaign.hole_test));
  const ProcessLimits limits{.seconds = campaign.time_limit,
                             .address_space_mb = campaign.memory_limit,
                             .output_mb = 64,
                             .is_interrupted = NotedInterrupt::is_noted};
  const std::vector<std::string>& names = campaign.engines;
  if (names.empty() || std::ranges::count(names, "all") > 0) {
    for (const Engine& other :
         {certified_engine(limits), proved_engine(limits, most_proved_segments)}) {
      const std::string fault = why_it_cannot_run(other.name, limits);
      if (fault.empty())
        chosen.push_back(other);
      else
        say_note("sums are not " + other.name + ": " + fault);
    }
    return chosen;
  }
  std::erase_if(chosen,
                [&](const Engine& engine) { return std::ranges::count(names, engine.name) == 0; });
  for (const std::string& name : names) {
    const std::string fault = why_it_cannot_run(name, limits);
    if (!fault.empty()) throw UsageError("cannot run " + one_line(name) + ": " + one_line(fault));
    if (auto other = engine_called(name, limits)) chosen.push_back(std::move(*other));
  }
  return chosen;
}

/// The report to go on from: that of the file if it exists.
CampaignReport first_report(CampaignReport begun, const std::string& resume) {
  if (resume.empty() || !std::filesystem::exists(resume)) return begun;
  CampaignReport kept = opened(text_of_file(resume, "the state of a run"), resume);
  std::string other = other_campaign(begun, kept);
  if (other.empty() && begun.shard.index != kept.shard.index) other = "it is of another shard";
  if (!other.empty()) throw UsageError(resume + " is the state of another run: " + other);
  kept.out = begun.out;
  say_note("going on after " + std::to_string(kept.done) + " of " +
           counted(kept.pairs, "pair", "pairs"));
  return kept;
}

CampaignReport run(const CompareOptions& options, CampaignReport report,
                   const std::vector<TaskSource>& sources, const Rules& rules) {
  Progress progress(report.report, report.pairs - report.done);
  RunWatch watch;
  watch.after_pair = [&] { progress.advance(); };
  watch.while_shrinking = [&](const ShrunkFailure& found) {
    progress.shrink(found.sum.failure.kind, size_of(found.sum.pair).vertices, found.tries);
  };
  watch.is_interrupted = NotedInterrupt::is_noted;
  if (!options.resume.empty())
    watch.keep = [&](const CampaignReport& now) { write_file(options.resume, sealed(now)); };
  const unsigned cores = std::max(std::thread::hardware_concurrency(), 1U);
  return run_campaign(std::move(report), sources, rules,
                      options.threads == 0 ? cores : options.threads, watch);
}

}  // namespace

void add_run_options(const Command& command, CompareOptions& options) {
  command
      .option(
          "--judge NAME", options.campaign.judge,
          "What computes the right sums. oracle: executes the definitions, about a minute for "
          "1000 segments of the convolution; convex-parts: the union of sums of convex parts, as "
          "oplus verify computes it, a tenth of a second for 5000")
      .one_of(texts(judges(), &Judge::name))
      .default_shown();
  command.option("--shard I/N", options.shard, "Only pairs of the I-th of N parts").default_shown();
  command.option("--resume FILE", options.resume,
                 "Keep the state in this file, and go on from it if it exists");
  command.option("--threads", options.threads, "Pairs at a time; default: one per core")
      .range(1, 1024);
  command.option("--out DIR", options.out, "Folder for disagreements").default_shown();
  command.option("--report FILE", options.reports,
                 "A report: .md for people, .json, .xml for a CI (JUnit); may be repeated");
  command.flag("--json", options.json, "Print the JSON report, not a table (docs/json.md)");
}

Option add_engine_option(const Command& command, CompareOptions& options, const std::string& what) {
  const std::vector<std::string> names = engine_names();
  const auto known =
      known_name("engine", names, "the engines are " + boost::join(names, ", ") + ", exec:CMD");
  return command.option("--engine NAME", options.campaign.engines, what)
      .one_of(names, [known](const std::string& name) {
        if (!engine_called(name, {})) known(name);
      });
}

void add_limit_options(const Command& command, CompareOptions& options) {
  Campaign& campaign = options.campaign;
  std::string defaults;
  for (const Judge& judge : judges())
    defaults +=
        (defaults.empty() ? "" : ", ") + std::to_string(judge.largest) + " for " + judge.name;
  command.option(
      "--largest", options.largest,
      "Skip, and count, pairs whose convolution has more segments; default: " + defaults);
  command.option("--time-limit", campaign.time_limit, "Seconds per sum of a peer or of exec:CMD")
      .positive()
      .default_shown();
  command.option("--memory-limit", campaign.memory_limit, "Their address space in MB; 0: unlimited")
      .default_shown();
}

void add_shrink_option(const Command& command, Campaign& campaign) {
  campaign.shrink = 3;
  command
      .option("--shrink", campaign.shrink,
              "The most disagreements to shrink: the smallest of each kind")
      .default_shown("3");
}

void add_pair_option(const Command& command, CompareOptions& options) {
  command.option("--pair P Q", options.pairs, "Only this pair of files; may be repeated")
      .values_each_time(2);
}

std::vector<Task> given_pairs(CompareOptions& options) {
  const Extent extent = options.campaign.is_of_sums() ? Extent::bounded : Extent::any;
  std::vector<Task> pairs;
  for (const auto& files : options.pairs)
    pairs.push_back(pair_of_files(files.at(0), files.at(1), extent));
  for (const Task& pair : pairs) options.campaign.pairs.push_back(pair.name);
  return pairs;
}

int compare(const std::string& command, CompareOptions options,
            const std::vector<TaskSource>& sources) {
  const Shard shard = shard_of(options.shard);
  for (const std::string& file : options.reports)
    if (!is_report_name(file))
      throw UsageError("--report " + file + ": the ending must be .md, .json or .xml");
  // Only the folder of counterexamples is made if it does not exist.
  const auto normal = [](const std::filesystem::path& folder) {
    return (folder / "").lexically_normal();
  };
  for (const std::string& file : options.reports)
    if (normal(std::filesystem::path(file).parent_path()) != normal(options.out))
      require_writable({file});
  const NotedInterrupt interrupt(
      "\ninterrupted: writing the report; a second interrupt ends the program at once\n");
  Rules rules{.engines = chosen_engines(options.campaign),
              .asks_beyond = command == "conformance",
              .judge = judge_named(options.campaign.judge)};
  if (!options.campaign.is_of_sums())
    rules = rules_of_operation(options.campaign.operation, std::move(rules));
  rules.largest = options.largest.value_or(rules.judge.largest);
  options.campaign.largest = rules.largest;
  options.campaign.engines.clear();
  for (const Engine& engine : rules.engines) options.campaign.engines.push_back(engine.name);

  CampaignReport begun = begun_report(command, options.campaign, shard, sources);
  begun.out = options.out;
  const CampaignReport report = run(options, first_report(begun, options.resume), sources, rules);
  write_counterexamples(report);
  for (const std::string& file : options.reports) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder);
    write_file(file, report_text(report, file));
  }
  std::ostream& text = text_output(options.json);
  for (const auto& [kind, found] : report.counterexamples) text << explanation(report, found);
  const bool is_good = report.conforms() && !report.compared_nothing() && !report.is_interrupted();
  text << with_painted_verdict(summary(report), is_good ? Paint::good : Paint::bad, std::cout);
  if (command == "diff")
    for (const std::string& file : options.reports) text << "report: " << file << '\n';
  if (options.json) std::cout << sealed(report);
  if (report.is_interrupted()) return 5;
  if (!report.conforms()) return 1;
  // A shard may consist of unsupported pairs; the campaign is judged as a whole.
  if (report.compared_nothing() && shard.of == 1)
    throw UsageError(command + " compared nothing: every pair was skipped");
  return 0;
}

}  // namespace oplus
