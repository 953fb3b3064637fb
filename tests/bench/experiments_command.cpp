// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/writing.hpp"
#include "tests/bench/experiment.hpp"
#include "tests/bench/measuring.hpp"
#include "tests/bench/numbers.hpp"
#include "tests/bench/report.hpp"
#include "tests/bench/templates.hpp"

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

using kainjow::mustache::object;

constexpr int exit_wrong = 1;
constexpr int exit_no_plots = 4;

bool is_drawn(const Plot& plot, const Rows& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
    return row.number(plot.needs) && (plot.family.empty() || row.words.at("family") == plot.family);
  });
}

/// A formula for gnuplot; NaN draws nothing.
std::string curve(const Experiment& experiment, const Rows& rows, const std::string& y) {
  if (experiment.fitted_over.empty()) return "NaN";
  const std::optional<Fit> fit =
      fitted_curve(experiment.fitted_degree, points(rows, experiment.fitted_over, y));
  return fit ? formula(*fit) : "NaN";
}

/// Measures and compares the rows of an experiment; writes NAME.csv, NAME.md and NAME.gp of each plot
/// that can be drawn. Returns its entry of the index; appends faults to `wrong`, names to `plots`.
PageData run(const Experiment& experiment, const ExperimentSettings& settings,
             std::vector<std::string>& wrong, std::vector<std::string>& plots) {
  Rows rows = experiment.rows(settings);
  for (Row& row : rows) {
    measure(row, row.engines, 0, {.address_space_mb = settings.memory_limit_mb}, std::cout);
    const std::vector<std::string> faults = faults_of(row);
    wrong.insert(wrong.end(), faults.begin(), faults.end());
    experiment.compare(row);
  }
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file((std::filesystem::path(settings.out) / name).string(), text);
  };
  write(experiment.name + ".csv", to_csv(rows, experiment.first_columns));
  write(experiment.name + ".md",
        rendered(experiment.name + ".md.mustache", object{{"table", table_section(rows)}}));
  std::vector<std::string> drawn;
  for (const Plot& plot : experiment.plots) {
    if (!is_drawn(plot, rows)) continue;
    const PageData script = object{{"name", plot.name},
                                   {"experiment", experiment.name},
                                   {"needs", plot.needs},
                                   {"family", plot.family},
                                   {"rca_curve", curve(experiment, rows, "rca.time")},
                                   {"winding_curve", curve(experiment, rows, "winding.time")}};
    write(plot.name + ".gp", rendered(plot.name + ".gp.mustache", script));
    drawn.push_back(plot.name);
  }
  plots.insert(plots.end(), drawn.begin(), drawn.end());
  return object{{"name", experiment.name},
                {"what", experiment.what},
                {"summary", page_data(experiment.summary(rows))},
                {"wrong", page_data(wrong)},
                {"plots", page_data(drawn)}};
}

/// The index of these experiments; with the machine, and the memory of a process that measures nothing.
std::string index_page(const ExperimentSettings& settings, const PageData& experiments) {
  const Measurement nothing =
      measured_in_own_process([](const auto&) { return Measurement{}; }, {});
  double load[1] = {0};
  const bool has_load = ::getloadavg(load, 1) == 1;
  const Setting setting = this_setting("", 0);
  return rendered("experiments.md.mustache",
                  object{{"seed", std::to_string(settings.seed)},
                         {"scale", three_digits(settings.scale)},
                         {"commit", setting.commit},
                         {"processor", setting.processor},
                         {"cores", std::to_string(setting.cores)},
                         {"load", has_load ? three_digits(load[0]) : "unknown"},
                         {"peak_mb", three_digits(nothing.numbers.at("peak_mb"))},
                         {"experiments", experiments}});
}

/// Runs gnuplot on each NAME.gp in its folder, which writes NAME.svg; reports in one line what failed.
/// Returns whether all are drawn.
bool draw_all(const std::string& folder, const std::vector<std::string>& plots) {
  constexpr int exit_not_found = 127;
  std::string failed;
  for (const std::string& plot : plots) {
    const std::string script =
        "command -v gnuplot >/dev/null || exit 127; cd \"$1\" && exec gnuplot \"$2\"";
    const EndedProcess ended =
        run_program({"/bin/sh", "-c", script, "sh", folder, plot + ".gp"}, {});
    if (ended.how == EndedProcess::How::exited && ended.code == 0) continue;
    if (ended.code == exit_not_found) {
      say_error("gnuplot is missing (package gnuplot-nox): " + std::to_string(plots.size()) +
                " plots not drawn; tables and scripts are in " + folder);
      return false;
    }
    failed += ' ' + plot;
  }
  if (!failed.empty()) say_error("gnuplot failed on" + failed);
  return failed.empty();
}

int run_all(const ExperimentSettings& settings) {
  // NaN passes CLI::Range.
  if (std::isnan(settings.scale)) throw UsageError("--scale: not a number");
  std::filesystem::create_directories(settings.out);
  const std::vector<std::string>& only = settings.only;
  kainjow::mustache::list entries;
  std::vector<std::string> plots;
  bool is_wrong = false;
  for (const Experiment& experiment : experiments()) {
    if (!only.empty() && std::ranges::find(only, experiment.name) == only.end()) continue;
    std::vector<std::string> wrong;
    entries.push_back(run(experiment, settings, wrong, plots));
    for (const std::string& line : wrong) say_error(line);
    is_wrong = is_wrong || !wrong.empty();
  }
  const std::string index = (std::filesystem::path(settings.out) / "index.md").string();
  write_file(index, index_page(settings, entries));
  const bool all_drawn = draw_all(settings.out, plots);
  std::cout << "index: " << index << '\n';
  if (is_wrong) return exit_wrong;
  return all_drawn ? 0 : exit_no_plots;
}

}  // namespace

std::function<int()> add_experiments_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("experiments", "Measure chapter 6 of the thesis again: tables and plots");
  const auto settings = std::make_shared<ExperimentSettings>();
  std::vector<std::string> names;
  std::string what = "Experiments:\n";
  for (const Experiment& experiment : experiments()) {
    names.push_back(experiment.name);
    what += "  " + experiment.name + std::string(16 - experiment.name.size(), ' ') +
            experiment.what + '\n';
  }
  command->add_option("--out", settings->out, "Folder for tables, plots and index.md")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--only", settings->only, "One experiment; may be repeated; default: all")
      ->type_name("NAME")
      ->check(CLI::IsMember(names));
  command
      ->add_option("--scale", settings->scale,
                   "Multiplies the largest size of each family; 0: only the smallest")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  command->add_option("--seed", settings->seed, "Same seed, same pairs")->capture_default_str();
  command
      ->add_option("--memory", settings->memory_limit_mb,
                   "Memory limit of a measurement in MB; 0: unlimited. One that needs more is "
                   "reported as a row")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1'000'000'000}))
      ->capture_default_str();
  command->footer(what +
                  "\n"
                  "Example:\n"
                  "  oplus-bench experiments --only fork-l --scale 0.4\n"
                  "\n"
                  "Exit codes:\n"
                  "  0  everything is written\n"
                  "  1  engines disagree, or an engine of oplus crashed or failed\n"
                  "  2  invalid usage, or a file that cannot be written\n"
                  "  4  tables are written, but gnuplot is missing or fails");
  return [settings] { return run_all(*settings); };
}

}  // namespace oplus
