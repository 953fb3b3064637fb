// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/experiments_command.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "properties/experiments/experiment_files.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr int exit_wrong = 1;
constexpr int exit_usage = 2;
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
bool draw_all(const std::filesystem::path& folder, const std::vector<Plot>& plots) {
  std::string failed;
  for (const Plot& plot : plots) {
    const Drawn drawn = draw(folder, plot);
    if (drawn == Drawn::no_gnuplot) {
      std::cerr << "oplus-check: gnuplot is missing (package gnuplot-nox), so " << plots.size()
                << " plots are not drawn; tables and scripts are in " << folder.string() << '\n';
      return false;
    }
    if (drawn == Drawn::failed) failed += ' ' + plot.name;
  }
  if (!failed.empty()) std::cerr << "oplus-check: gnuplot fails on" << failed << '\n';
  return failed.empty();
}

int run(const Settings& settings) {
  if (std::isnan(settings.of_each.scale)) {  // it passes every range
    std::cerr << "oplus-check: --scale: not a number\n";
    return exit_usage;
  }
  const std::filesystem::path folder = settings.out;
  std::filesystem::create_directories(folder);
  std::string index = index_head(settings.of_each);
  std::vector<Plot> plots;
  std::vector<std::string> wrong;
  for (const Experiment& experiment : experiments()) {
    const auto& only = settings.only;
    if (!only.empty() && std::find(only.begin(), only.end(), experiment.name) == only.end())
      continue;
    const ExperimentResult result = experiment.run(settings.of_each);
    write_experiment(folder, experiment, result);
    index += index_entry(experiment, result);
    plots.insert(plots.end(), result.plots.begin(), result.plots.end());
    wrong.insert(wrong.end(), result.wrong.begin(), result.wrong.end());
  }
  write_file((folder / "index.md").string(), index);
  const bool all_drawn = draw_all(folder, plots);
  for (const std::string& line : wrong) std::cerr << "oplus-check: " << line << '\n';
  std::cout << "index: " << (folder / "index.md").string() << '\n';
  if (!wrong.empty()) return exit_wrong;
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
                  "  oplus-check experiments --only fork-l --scale 0.4\n"
                  "\n"
                  "Exit codes:\n"
                  "  0  all is written\n"
                  "  1  engines disagree or a measurement died\n"
                  "  2  a request that makes no sense or a file that cannot be written\n"
                  "  4  tables are written but gnuplot is missing or fails");
  command->callback([settings, &exit_code] { exit_code = run(*settings); });
}

}  // namespace oplus
