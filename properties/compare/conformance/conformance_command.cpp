// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance/conformance_command.hpp"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <thread>

#include "checked/cli/command_line/terminal.hpp"
#include "properties/compare/conformance/run.hpp"
#include "properties/compare/engine_called.hpp"
#include "properties/compare/limit_options.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/progress.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

namespace {

struct Settings {
  ConformanceSettings asked;
  std::string engine;
  std::vector<std::vector<std::string>> pairs;
  std::string shard = "1/1";
  unsigned threads = std::max(std::thread::hardware_concurrency(), 1U);
  std::string out = "oplus-findings";
  std::vector<std::string> reports;
  bool json = false;
};

/// One of our engines, a peer or a command.
std::optional<Engine> engine_named(const std::string& name, const PeerLimits& limits) {
  const std::vector<Engine> own = checked_engines();
  if (const Engine* engine = find_engine(own, name)) return *engine;
  return engine_called(name, limits);
}

ConformancePlan plan(const Settings& settings) {
  if (settings.pairs.empty()) return conformance_plan(settings.asked);
  std::vector<std::pair<std::string, Summands>> pairs;
  for (const auto& files : settings.pairs)
    pairs.emplace_back(
        files.at(0) + " " + files.at(1),
        Summands{read_region_file(files.at(0)).region, read_region_file(files.at(1)).region});
  return plan_of_pairs(pairs);
}

void print(std::ostream& out, const ConformanceReport& report, const std::string& folder) {
  const auto line = [&out](const std::string& name, const ConformanceTally& tally) {
    out << std::left << std::setw(12) << name << std::right << std::setw(8) << tally.pairs;
    for (const auto& [ruling, word] : rulings())
      out << std::setw(static_cast<int>(std::max<std::size_t>(word.size(), 6)) + 2)
          << tally.count(ruling);
    out << '\n';
  };
  out << std::setw(20) << "pairs";
  for (const auto& [ruling, word] : rulings())
    out << std::setw(static_cast<int>(std::max<std::size_t>(word.size(), 6)) + 2) << word;
  out << '\n';
  for (std::size_t i = 0; i < report.groups.size();) {
    const std::string& part = report.groups[i].part;
    ConformanceTally tally;
    for (; i < report.groups.size() && report.groups[i].part == part; ++i)
      tally += report.tallies[i];
    line(part, tally);
  }
  const ConformanceTally all = report.all();
  line("all", all);
  for (const auto& [kind, times] : all.kinds) {
    const ShrunkFailure& of = report.counterexamples.at(kind);
    out << kind << ": " << counted(times, "sum", "sums") << "; a pair of "
        << size_of(of.seen.summands).vertices << " vertices, in " << folder << ":\n  "
        << replay_line(report, of) << '\n';
  }
  out << report.engine << (report.conforms() ? " conforms" : " does not conform") << ": "
      << all.count(Ruling::passed) << " sums passed, " << all.failures() << " failures of "
      << counted(all.kinds.size(), "kind", "kinds") << '\n';
}

int refused(const std::string& why) {
  say_error(why);
  return 2;
}

int conformance(Settings settings) {
  const auto shard = shard_of(settings.shard);
  if (!shard) return refused(no_shard(settings.shard));
  settings.asked.shard = *shard;
  for (const std::string& file : settings.reports) {
    if (!is_report_name(file))
      return refused("--report " + file + " ends in none of .md, .json and .xml");
  }
  const std::optional<Engine> engine = engine_named(settings.engine, settings.asked.limits);
  if (!engine) return refused("there is no engine " + settings.engine);

  const ConformancePlan planned = plan(settings);
  Progress progress("conformance", shard->cases_of(planned.trials.size()).size());
  ConformanceReport report = run_conformance(*engine, settings.asked, planned, settings.threads,
                                             [&] { progress.advance(); });
  for (const auto& files : settings.pairs) report.pairs.push_back(files.at(0) + " " + files.at(1));
  write_counterexamples(report, settings.out);
  for (const std::string& file : settings.reports) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder);
    write_file(file, conformance_text(report, file));
  }
  print(text_output(settings.json), report, settings.out);
  if (settings.json) std::cout << conformance_text(report, ".json");
  if (!report.conforms()) return 1;
  // A shard may be too small to have asked anything that is taken; the campaign is judged as a whole.
  if (report.all().count(Ruling::passed) == 0 && shard->of == 1)
    return refused("conformance compared nothing: every sum was not taken or skipped");
  return 0;
}

}  // namespace

void add_conformance_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "conformance", "Check all that must hold of sums against one implementation");
  const auto settings = std::make_shared<Settings>();
  ConformanceSettings& asked = settings->asked;
  command
      ->add_option(
          "--engine", settings->engine,
          "The implementation: an engine of oplus, a peer, or exec:CMD, as diff takes them")
      ->type_name("NAME")
      ->required();
  command->add_option("--pair", settings->pairs, "Only this pair of files; may be repeated")
      ->type_name("P Q")
      ->type_size(2);
  command->add_option("--part", asked.parts, "Only this part; may be repeated")
      ->type_name("NAME")
      ->check(CLI::IsMember(conformance_parts()));
  command->add_option("--seed", asked.seed, "Same seed, same pairs")->capture_default_str();
  command->add_option("--budget", asked.budget, "Pairs in all, the corpus not counted")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}))
      ->capture_default_str();
  command->add_option("--cases", asked.cases, "Pairs a grid, family, statement or law, instead")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}));
  command
      ->add_option("--largest", asked.largest,
                   "Skip, and count, pairs whose convolution has more segments")
      ->capture_default_str();
  command
      ->add_option("--shrink", asked.shrink_tries,
                   "Try at most so many pairs to shrink a counterexample; of hangs a twentieth")
      ->capture_default_str();
  add_limit_options(*command, asked.limits);
  command->add_option("--shard", settings->shard, "Only trials of the I-th of N parts")
      ->type_name("I/N")
      ->capture_default_str();
  command->add_option("--threads", settings->threads, "Trials at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--out", settings->out, "Folder for counterexamples")
      ->type_name("DIR")
      ->capture_default_str();
  command
      ->add_option("--report", settings->reports,
                   "A report: .md for people, .json, .xml for a CI (JUnit); may be repeated")
      ->type_name("FILE");
  command->add_flag("--json", settings->json, "Print the JSON report, not a table (docs/json.md)");
  command->footer(
      "Parts, in the order of the run: grids (all pairs of small polygons on small grids, or an even\n"
      "selection), corpus, families (random pairs against the oracle), statements (of the thesis),\n"
      "laws (of the sum).\n"
      "\n"
      "Example:\n"
      "  oplus-check conformance --engine slide --report conformance.md\n"
      "  oplus-check conformance --engine 'exec:my-sum {p} {q}' --report conformance.xml\n"
      "\n"
      "Exit codes:\n"
      "  0  it conforms\n"
      "  1  it does not\n"
      "  2  bad input or a request that makes no sense");
  command->callback([settings, &exit_code] { exit_code = conformance(*settings); });
}

}  // namespace oplus
