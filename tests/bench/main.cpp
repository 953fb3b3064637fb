// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <regex>

#include "checked/cli/command_line/program_frame.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "properties/runner/source_tree.hpp"
#include "reference/io/writing.hpp"
#include "tests/bench/experiment.hpp"
#include "tests/bench/measuring.hpp"
#include "tests/bench/page.hpp"
#include "tests/bench/published_pairs.hpp"
#include "tests/bench/rows.hpp"

namespace oplus {

namespace {

constexpr int exit_wrong = 1;
constexpr auto file_type = "FILE";
constexpr auto group = "Options without a command";

struct Options {
  std::string rows = ".*";
  std::vector<std::string> engines;
  ProcessLimits limits{.seconds = 60};
  double min_time = 0.5;
  bool list = false;
  bool engines_at_fault = false;
  std::string json;
  std::string markdown;
  std::string from;
};

/// The engines of the benchmark's rows; faulty ones only with --engines-at-fault.
std::vector<BenchEngine> offered_engines(const Options& options) {
  std::vector<BenchEngine> offered = bench_engines();
  std::erase_if(offered, [&](const BenchEngine& engine) {
    return engine.subject == Subject::hole_tests ||
           (engine.is_at_fault && !options.engines_at_fault);
  });
  return offered;
}

std::vector<std::string> chosen_engines(const Options& options) {
  std::vector<std::string> offered;
  for (const BenchEngine& engine : offered_engines(options))
    // Faulty ones only by name.
    if (!engine.is_at_fault || !options.engines.empty()) offered.push_back(engine.name);
  if (options.engines.empty()) return offered;
  for (const std::string& name : options.engines)
    if (std::ranges::find(offered, name) == offered.end())
      throw UsageError("unknown engine " + name + "; --list shows all");
  return options.engines;
}

Rows chosen_rows(const Options& options) {
  try {
    const std::regex pattern(options.rows);
    Rows chosen = rows_where(benchmark_rows(),
                             [&](const Row& row) { return std::regex_match(row.name, pattern); });
    if (chosen.empty()) throw UsageError("no row matches " + options.rows);
    return chosen;
  } catch (const std::regex_error& e) {
    throw UsageError("--rows: " + std::string(e.what()));
  }
}

void list(const Options& options) {
  std::cout << "rows\n";
  for (const Row& row : chosen_rows(options))
    std::cout << "  " << row.name << ": " << row.what << '\n';
  std::cout << "engines\n";
  for (const BenchEngine& engine : offered_engines(options))
    std::cout << "  " << engine.name << ": " << engine.what << '\n';
}

Report read_report(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw UsageError("cannot open " + path);
  try {
    return report_of({std::istreambuf_iterator<char>(file), {}});
  } catch (const std::invalid_argument& e) {
    throw UsageError(path + ": " + e.what());
  }
}

Report measured_report(const Options& options, const std::string& command) {
  Report report{this_setting(command, options.limits.seconds), {}};
  for (const PublishedPair& pair : published_pairs())
    if (!pair.what.empty() && !pair.is_there()) report.setting.missing.push_back(pair.name);
  const std::vector<std::string> of_run = chosen_engines(options);
  for (Row& row : chosen_rows(options)) {
    if (std::ranges::find_first_of(row.engines, of_run) == row.engines.end()) continue;
    measure(row, of_run, options.min_time, options.limits, std::cout);
    report.rows.push_back(std::move(row));
    // An interrupted run keeps what it has measured.
    if (!options.json.empty()) write_file(options.json, to_json(report));
  }
  for (const std::string& name : report.setting.missing)
    std::cout << "skipped, missing in " << data_folder().string() << ": published_" << name << '\n';
  return report;
}

int run(const Options& options, const std::string& command) {
  if (options.list) {
    list(options);
    return 0;
  }
  const Report report =
      options.from.empty() ? measured_report(options, command) : read_report(options.from);
  if (!options.markdown.empty())
    write_file(options.markdown, rendered("benchmarks.md.mustache", benchmarks_data(report)));
  bool is_wrong = false;
  for (const Row& row : report.rows) {
    for (const std::string& fault : faults_of(row)) {
      say_error(fault);
      is_wrong = true;
    }
  }
  return is_wrong ? exit_wrong : 0;
}

/// In quotes where a shell would not take it as one plain word.
std::string shell_word(const std::string& argument) {
  const bool is_plain = argument.find_first_of("*?[]{}()|&;<>$`\\\"' \t#~!^") == std::string::npos;
  return is_plain && !argument.empty() ? argument : '\'' + argument + '\'';
}

/// The options of the benchmark that were given.
std::vector<const CLI::Option*> given_options(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) {
    return option->count() > 0 && option->get_group() == group;
  });
}

/// The command that measures the same; without its files, which are of one machine only.
std::string command_of(const CLI::App& app) {
  std::string command = "build/release/bin/oplus-bench";
  for (const CLI::Option* option : given_options(app)) {
    if (option->get_type_name() == file_type) continue;
    command += ' ' + option->get_name();
    if (option->get_items_expected() > 0)
      command += ' ' + shell_word(boost::join(option->results(), ","));
  }
  return command;
}

std::function<int()> add_options(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.require_subcommand(0, 1);
  const std::string group_of_all = app.option_defaults()->get_group();
  app.option_defaults()->group(group);
  app.add_option("--rows", options->rows, "Only rows whose whole name matches")->type_name("REGEX");
  app.add_option("--engines", options->engines, "Only these engines, separated by commas")
      ->type_name("LIST")
      ->delimiter(',');
  app.add_option("--limit", options->limits.seconds, "Seconds after which a run is stopped")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option(
         "--min-time", options->min_time,
         "Least total seconds of an engine's runs; a run of more than a second is not repeated")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--list", options->list, "List the rows and the engines");
  app.add_option("--json", options->json, "Write the measurements to FILE")->type_name(file_type);
  app.add_option("--markdown", options->markdown, "Write a page like docs/benchmarks.md to FILE")
      ->type_name(file_type);
  app.add_option("--from", options->from, "Measure nothing, read what --json wrote")
      ->type_name(file_type);
  app.add_flag("--engines-at-fault", options->engines_at_fault,
               "Also offer engines that crash, hang and are wrong, to test the benchmark")
      ->group("");
  app.option_defaults()->group(group_of_all);
  const std::function<int()> run_experiments = add_experiments_command(app);
  return [=, &app] {
    if (app.get_subcommands().empty()) return run(*options, command_of(app));
    for (const CLI::Option* option : given_options(app))
      throw UsageError(option->get_name() + " does not apply to experiments");
    return run_experiments();
  };
}

const ProgramFrame frame{
    "oplus-bench",
    "Measures Minkowski sums by oplus, CGAL, Clipper and Boost.Polygon, each in a process of its "
    "own, and compares the results",
    "Exit code: 0 all exact results are equal, 1 they are not or an engine of oplus crashed or "
    "failed, 2 invalid usage. Another library that crashes or is too slow is a result."};

}  // namespace

}  // namespace oplus

int main(int argc, char** argv) {
  const auto add = [](oplus::Program& program) { program.work = oplus::add_options(program.app); };
  return oplus::run_program(oplus::frame, add, argc, argv);
}
