// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "tests/bench/experiment_files.hpp"
#include "tests/bench/measuring.hpp"

namespace oplus {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = [] {
    std::vector<Experiment> made = sum_experiments();
    made.push_back(hole_test_experiment());
    made.push_back(cycle_experiment());
    return made;
  }();
  return all;
}

namespace {

constexpr int exit_wrong = 1;
constexpr int exit_no_plots = 4;

struct Settings {
  ExperimentSettings of_each;
  std::vector<std::string> only;
  std::string out = "oplus-experiments";
};

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const Experiment& experiment : experiments()) result.push_back(experiment.name);
  return result;
}

/// Draws all plots; says what is missing in one line. Returns whether all are drawn.
bool draw_all(const std::filesystem::path& folder, const std::vector<std::string>& plots) {
  std::string failed;
  for (const std::string& plot : plots) {
    const Drawn drawn = draw(folder, plot);
    if (drawn == Drawn::no_gnuplot) {
      say_error("gnuplot is missing (package gnuplot-nox), so " + std::to_string(plots.size()) +
                " plots are not drawn; tables and scripts are in " + folder.string());
      return false;
    }
    if (drawn == Drawn::failed) failed += ' ' + plot;
  }
  if (!failed.empty()) say_error("gnuplot fails on" + failed);
  return failed.empty();
}

/// The rows of an experiment, measured and compared. Appends what is wrong.
std::vector<Row> measured_rows(const Experiment& experiment, const ExperimentSettings& settings,
                               std::vector<std::string>& wrong) {
  MeasuringLimits limits;
  limits.memory_mb = settings.memory_limit_mb;
  std::vector<Row> rows = experiment.rows(settings);
  for (Row& row : rows) {
    measure(row, row.engines, 0, limits, std::cout);
    const std::vector<std::string> faults = faults_of(row);
    wrong.insert(wrong.end(), faults.begin(), faults.end());
    experiment.compare(row);
  }
  return rows;
}

int run(const Settings& settings) {
  // It passes every range.
  if (std::isnan(settings.of_each.scale)) throw UsageError("--scale: not a number");
  const std::filesystem::path folder = settings.out;
  std::filesystem::create_directories(folder);
  PageData entries(PageData::type::list);
  std::vector<std::string> plots;
  bool is_wrong = false;
  for (const Experiment& experiment : experiments()) {
    const auto& only = settings.only;
    if (!only.empty() && std::find(only.begin(), only.end(), experiment.name) == only.end())
      continue;
    std::vector<std::string> wrong;
    const std::vector<Row> measured = measured_rows(experiment, settings.of_each, wrong);
    entries << write_experiment(folder, experiment, pointers(measured), wrong, plots);
    for (const std::string& line : wrong) say_error(line);
    is_wrong = is_wrong || !wrong.empty();
  }
  write_index(folder, settings.of_each, entries);
  const bool all_drawn = draw_all(folder, plots);
  std::cout << "index: " << (folder / "index.md").string() << '\n';
  if (is_wrong) return exit_wrong;
  return all_drawn ? 0 : exit_no_plots;
}

}  // namespace

void add_experiments_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("experiments", "Measure chapter 6 of the thesis again: tables and plots");
  const auto settings = std::make_shared<Settings>();
  command->add_option("--out", settings->out, "Folder for tables, plots and index.md")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--only", settings->only, "One experiment; may be repeated; default: all")
      ->type_name("NAME")
      ->check(CLI::IsMember(names()));
  command
      ->add_option("--scale", settings->of_each.scale,
                   "Multiplies the largest size of each family; 0: only the smallest")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  command->add_option("--seed", settings->of_each.seed, "Same seed, same pairs")
      ->capture_default_str();
  command
      ->add_option("--memory", settings->of_each.memory_limit_mb,
                   "Most memory of a measurement, in MB; one that needs more is a row that says "
                   "so; 0: no limit")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1'000'000'000}))
      ->capture_default_str();
  std::string what = "Experiments:\n";
  for (const Experiment& experiment : experiments())
    what += "  " + experiment.name + std::string(16 - experiment.name.size(), ' ') +
            experiment.what + '\n';
  command->footer(what +
                  "\n"
                  "Example:\n"
                  "  oplus-bench experiments --only fork-l --scale 0.4\n"
                  "\n"
                  "Exit codes:\n"
                  "  0  all is written\n"
                  "  1  engines disagree or a measurement died\n"
                  "  2  a request that makes no sense or a file that cannot be written\n"
                  "  4  tables are written but gnuplot is missing or fails");
  command->callback([settings, &exit_code] { exit_code = run(*settings); });
}

}  // namespace oplus
