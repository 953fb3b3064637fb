// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/diff_command.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "checked/arrangement/hole_test.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/engines.hpp"
#include "properties/compare/differential_cases.hpp"
#include "properties/compare/differential_report.hpp"
#include "properties/compare/engine_called.hpp"
#include "properties/compare/limit_options.hpp"
#include "properties/compare/sealed_report.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/progress.hpp"
#include "properties/runner/property_run.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Settings {
  std::vector<std::string> engines;
  std::string hole_test = "all";
  std::vector<std::vector<std::string>> pairs;
  std::vector<std::string> folders;
  std::vector<std::string> families;
  std::optional<std::size_t> cases;
  std::optional<std::size_t> n;
  std::uint64_t seed = 1;
  std::size_t largest = 1300;
  unsigned threads = std::max(std::thread::hardware_concurrency(), 1U);
  std::size_t most_shrunk = 3;
  std::size_t shrink_tries = 5000;
  PeerLimits limits;
  std::string out = "oplus-findings";
  std::string report;
  bool json = false;
  std::string shard = "1/1";
};

template <typename Named>
std::vector<std::string> names_of(const std::vector<Named>& table) {
  std::vector<std::string> names;
  for (const Named& entry : table) names.push_back(entry.name);
  return names;
}

HoleTestMethod chosen_hole_test(const std::string& name) {
  for (const auto& [known, method] : hole_test_methods())
    if (known == name) return method;
  return all_hole_tests();
}

std::vector<std::string> hole_test_names() {
  std::vector<std::string> names = {"all"};
  for (const auto& [name, method] : hole_test_methods()) names.push_back(name);
  return names;
}

CLI::Validator engine_name() {
  std::string offered = "all";  // for completion, which is told nothing of exec:CMD
  for (const Engine& own : engines()) offered += "," + own.name;
  for (const Engine& peer : peers()) offered += "," + peer.name;
  return CLI::Validator(
      [](const std::string& name) -> std::string {
        std::vector<std::string> known = names_of(engines());
        known.emplace_back("all");
        if (std::find(known.begin(), known.end(), name) != known.end() ||
            engine_called(name, PeerLimits()))
          return "";
        std::string names;
        for (const std::string& own : known) names += own + ", ";
        for (const Engine& peer : peers()) names += peer.name + ", ";
        return name + " is no engine; there are " + names + "exec:CMD";
      },
      "{" + offered + "}");
}

std::string peer_list() {
  std::string lines;
  for (const Engine& peer : peers())
    lines += "  " + peer.name + std::string(22 - peer.name.size(), ' ') + peer.what + '\n';
  return lines;
}

std::vector<Engine> chosen_engines(const Settings& settings) {
  const std::vector<std::string>& names = settings.engines;
  std::vector<Engine> chosen = checked_engines(chosen_hole_test(settings.hole_test));
  if (names.empty() || std::find(names.begin(), names.end(), "all") != names.end()) return chosen;
  std::erase_if(chosen, [&](const Engine& implementation) {
    return std::find(names.begin(), names.end(), implementation.name) == names.end();
  });
  for (const std::string& name : names)
    if (auto peer = engine_called(name, settings.limits)) chosen.push_back(std::move(*peer));
  return chosen;
}

/// The cases that were asked for; where none was, those of the main job: the published pairs, where
/// they are present, and all families.
std::vector<DifferentialCase> chosen_cases(const Settings& settings) {
  std::vector<DifferentialCase> cases;
  const auto append = [&](std::vector<DifferentialCase> more) {
    std::move(more.begin(), more.end(), std::back_inserter(cases));
  };
  for (const auto& pair : settings.pairs) cases.push_back(case_of_files(pair.at(0), pair.at(1)));
  for (const std::string& folder : settings.folders) append(cases_of_folder(folder));
  std::vector<std::string> names = settings.families;
  if (names.empty() && cases.empty() && settings.pairs.empty() && settings.folders.empty()) {
    if (std::filesystem::is_directory(OPLUS_DATA_DIR))
      append(cases_of_folder(OPLUS_DATA_DIR));
    else
      text_output(settings.json || speech().quiet)
          << "the published pairs are left out: there is no folder " << OPLUS_DATA_DIR << '\n';
    names = names_of(families());
  }
  for (const std::string& name : names)
    append(cases_of_family(*find_family(name), settings.cases.value_or(main_job_cases(name)),
                           settings.seed, settings.n));
  return cases;
}

/// All that decides what is run, and who says so.
nlohmann::json campaign(const Settings& settings, const std::vector<std::string>& engines,
                        const std::vector<DifferentialCase>& cases) {
  std::string names;
  for (const DifferentialCase& one : cases) names += one.name + '\n';
  return {{"engines", engines},
          {"hole_test", settings.hole_test},
          {"seed", settings.seed},
          {"largest", settings.largest},
          {"shrink", settings.most_shrunk},
          {"shrink_tries", settings.shrink_tries},
          {"time_limit", settings.limits.seconds},
          {"memory_limit", settings.limits.memory_mb},
          {"cases", cases.size()},
          {"names_of_cases", seed_of(names, 0)}};
}

/// Runs all cases of the shard; shrinks, writes and explains the first few disagreements.
DifferentialReport run(const Settings& settings, const Shard& shard,
                       const std::vector<DifferentialCase>& all_cases) {
  const std::vector<std::size_t> indices = shard.cases_of(all_cases.size());
  std::vector<DifferentialCase> cases;
  for (const std::size_t i : indices) cases.push_back(all_cases[i]);
  const std::vector<Engine> checked = chosen_engines(settings);
  DifferentialReport report;
  report.shard = shard;
  report.seed = settings.seed;
  report.implementations = names_of(checked);
  report.campaign = campaign(settings, report.implementations, all_cases);
  if (settings.hole_test != "all") report.hole_test = settings.hole_test;
  std::vector<DifferentialResult> results(cases.size());
  Progress progress("diff", cases.size());
  run_differential(cases, checked, settings.largest, settings.threads,
                   [&](std::size_t index, const DifferentialResult& result) {
                     results[index] = result;
                     results[index].by_oracle.reset();  // thousands of them
                     progress.advance();
                   });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const DifferentialResult& result = results[i];
    report.all.add(result);
    report.groups[cases[i].group].add(result);
    if (result.kind == DifferentialResult::Kind::skipped)
      report.skipped.push_back({indices[i], cases[i].name, result.why});
    if (result.kind != DifferentialResult::Kind::disagreed) continue;
    if (report.disagreements.size() == settings.most_shrunk) continue;
    text_output(settings.json || speech().quiet)
        << "shrinking a disagreement found in " << cases[i].name << std::endl;
    report.disagreements.push_back(write_disagreement(
        settings.out, cases[i].name,
        shrink(cases[i].make(), *result.disagreement, checked, settings.shrink_tries)));
    report.disagreements.back().index = indices[i];
    text_output(settings.json) << explanation(report.disagreements.back()) << std::flush;
  }
  return report;
}

int diff(const Settings& settings) {
  const std::optional<Shard> shard = shard_of(settings.shard);
  if (!shard) {
    say_error(no_shard(settings.shard));
    return 2;
  }
  const std::vector<DifferentialCase> cases = chosen_cases(settings);
  if (cases.empty()) {
    say_error("diff found no pair to compare");
    return 2;
  }
  const DifferentialReport report = run(settings, *shard, cases);
  const std::string file = settings.report.empty()
                               ? (std::filesystem::path(settings.out) / "diff.json").string()
                               : settings.report;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  const std::string json = sealed(to_json(report));
  write_file(file, json);
  text_output(settings.json) << with_painted_verdict(
                                    summary(report),
                                    report.all.disagreed == 0 ? Paint::good : Paint::bad, std::cout)
                             << "report: " << file << '\n';
  if (settings.json) std::cout << json;
  if (report.all.ran == 0 && shard->of == 1) {
    say_error("diff compared nothing: every pair was skipped");
    return 2;
  }
  return report.all.disagreed == 0 ? 0 : 1;
}

}  // namespace

void add_diff_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "diff",
      "Compare engines with the oracle, on pairs that are named or on those of the main job");
  const auto settings = std::make_shared<Settings>();
  command
      ->add_option("--engine", settings->engines,
                   "The engine to check; may be repeated; default: all of oplus; below, those of "
                   "others")
      ->type_name("NAME")
      ->check(engine_name());
  command
      ->add_option("--hole-test", settings->hole_test,
                   "The hole test of the engines; all: every probe asks each, and they must agree")
      ->type_name("NAME")
      ->check(CLI::IsMember(hole_test_names()))
      ->capture_default_str();
  command->add_option("--pair", settings->pairs, "A pair of files; may be repeated")
      ->type_name("P Q")
      ->type_size(2);
  command
      ->add_option("--folder", settings->folders,
                   "The files of a folder: NAME_part1 with NAME_part2, all others with each other")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  command->add_option("--family", settings->families, "A generated family; may be repeated")
      ->type_name("NAME")
      ->check(CLI::IsMember(names_of(families())));
  command
      ->add_option("--cases", settings->cases,
                   "Pairs of each family; default: those of the main job")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}));
  command->add_option("--n", settings->n,
                      "The largest size of a generated pair, as the family understands it");
  command->add_option("--seed", settings->seed, "Same seed, same pairs")->capture_default_str();
  command
      ->add_option("--largest", settings->largest,
                   "Skip, and count, pairs whose convolution has more segments")
      ->capture_default_str();
  command->add_option("--threads", settings->threads, "Cases at a time; default: one a core")
      ->check(CLI::Range(1, 1024));
  command->add_option("--shrink", settings->most_shrunk, "Shrink at most so many disagreements")
      ->capture_default_str();
  command->add_option("--shrink-tries", settings->shrink_tries, "Pairs tried to shrink one")
      ->capture_default_str();
  add_limit_options(*command, settings->limits);
  command->add_option("--shard", settings->shard, "Only cases of the I-th of N parts")
      ->type_name("I/N")
      ->capture_default_str();
  command->add_option("--out", settings->out, "Folder for disagreements and the report")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--report", settings->report, "The report; default: diff.json in --out")
      ->type_name("FILE");
  command->add_flag("--json", settings->json, "Print the report, not a table (docs/json.md)");
  command->footer(
      "Engines of others, each sum in a process of its own:\n" + peer_list() +
      "  exec:CMD              any program: the shell runs CMD with {p} and {q} replaced by files\n"
      "                        in WKT, or these appended; it writes the sum. Open sums: where CMD\n"
      "                        has {boundary}, which is replaced by closed or open. Exit code 77:\n"
      "                        not taken.\n"
      "\n"
      "Example:\n"
      "  oplus-check diff --family grid --cases 500 --seed 7\n"
      "  oplus-check diff --pair p.wkt q.wkt --engine slide\n"
      "  oplus-check diff --engine 'exec:my-sum {p} {q}' --time-limit 5 --family holes\n"
      "\n"
      "Exit codes:\n"
      "  0  all agree\n"
      "  1  a disagreement\n"
      "  2  bad input, a request that makes no sense, or nothing compared");
  command->callback([settings, &exit_code] { exit_code = diff(*settings); });
}

}  // namespace oplus
