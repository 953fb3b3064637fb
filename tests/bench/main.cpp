// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

#include "reference/io/writing.hpp"
#include "tests/bench/page.hpp"
#include "tests/bench/terminal.hpp"
#include "tests/bench/worker.hpp"

namespace oplus {

namespace {

constexpr int exit_wrong = 1;
constexpr int exit_usage = 2;

struct Options {
  std::string rows = ".*";
  std::vector<std::string> engines;
  double limit = 60;
  double min_time = 0.5;
  bool list = false;
  bool engines_at_fault = false;
  std::string json;
  std::string markdown;
  std::string from;
  std::vector<std::string> worker;
};

/// Those that are not at fault, unless asked for.
std::vector<BenchmarkedEngine> offered_engines(const Options& options) {
  std::vector<BenchmarkedEngine> offered = benchmarked_engines();
  if (!options.engines_at_fault) offered.resize(offered.size() - engines_at_fault);
  return offered;
}

std::vector<BenchmarkedEngine> chosen_engines(const Options& options) {
  std::vector<BenchmarkedEngine> offered = offered_engines(options);
  if (options.engines.empty()) {
    // Those at fault never come unasked.
    offered.resize(std::min(offered.size(), benchmarked_engines().size() - engines_at_fault));
    return offered;
  }
  std::vector<BenchmarkedEngine> chosen;
  for (const std::string& name : options.engines) {
    const auto found = std::find_if(offered.begin(), offered.end(),
                                    [&](const BenchmarkedEngine& e) { return e.name == name; });
    if (found == offered.end()) throw std::invalid_argument("no engine is called " + name);
    chosen.push_back(*found);
  }
  return chosen;
}

std::vector<BenchRow> chosen_rows(const Options& options) {
  const std::regex pattern(options.rows);
  std::vector<BenchRow> chosen;
  std::copy_if(rows().begin(), rows().end(), std::back_inserter(chosen),
               [&](const BenchRow& row) { return std::regex_match(row.name, pattern); });
  if (chosen.empty()) throw std::invalid_argument("no row matches " + options.rows);
  return chosen;
}

void list(const Options& options) {
  std::cout << "rows\n";
  for (const BenchRow& row : chosen_rows(options))
    std::cout << "  " << row.name << ": " << row.what << '\n';
  std::cout << "engines\n";
  for (const BenchmarkedEngine& engine : offered_engines(options))
    std::cout << "  " << engine.name << ": " << engine.what << '\n';
}

int work(const Options& options) {
  const BenchmarkedEngine* engine = find_benchmarked_engine(options.worker.at(0));
  const BenchRow* row = find_row(options.worker.at(1));
  if (engine == nullptr || row == nullptr)
    throw std::invalid_argument("no such engine or no such row");
  work(*engine, *row, options.min_time);
}

Report read_report(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::invalid_argument("cannot open " + path);
  return nlohmann::ordered_json::parse(file).get<Report>();
}

std::string page_template() {
  std::ifstream file(OPLUS_BENCH_PAGE);
  if (!file) throw std::invalid_argument("cannot open " OPLUS_BENCH_PAGE);
  return {std::istreambuf_iterator<char>(file), {}};
}

Report measured(const Options& options, const std::string& command) {
  Report report{this_setting(command, options.limit), {}};
  const std::vector<BenchmarkedEngine> of_run = chosen_engines(options);
  for (const BenchRow& row : chosen_rows(options)) {
    if (std::none_of(of_run.begin(), of_run.end(),
                     [&](const BenchmarkedEngine& engine) { return is_for(engine.name, row); }))
      continue;
    write_head(std::cout, row);
    report.rows.push_back({row.name, row.group, row.what, row.subject, row.pairs, {}});
    for (const BenchmarkedEngine& engine : of_run) {
      if (!is_for(engine.name, row)) continue;
      report.rows.back().measurements.push_back(
          measured_in_worker(engine, row, options.min_time, options.limit));
      write_line(std::cout, report.rows.back().measurements.back());
    }
    write_agreement(std::cout, report.rows.back());
    // What has been measured is not lost where the run is ended.
    if (!options.json.empty())
      write_file(options.json, nlohmann::ordered_json(report).dump(1) + '\n');
  }
  for (const std::string& name : report.setting.missing)
    std::cout << "skipped, not in " OPLUS_DATA_DIR ": published_" << name << '\n';
  return report;
}

/// Whether exact engines disagree, or one of ours was lost on the way.
bool is_wrong(const Report& report) {
  bool wrong = false;
  for (const RowReport& row : report.rows) {
    const std::string disagreement = agreement_of(row).disagreement;
    if (!disagreement.empty()) {
      std::cerr << "oplus-bench: " << row.name << ": " << disagreement << " disagree\n";
      wrong = true;
    }
    for (const Measurement& m : row.measurements) {
      const BenchmarkedEngine* engine = find_benchmarked_engine(m.engine);
      const bool lost = m.outcome == Outcome::crashed || m.outcome == Outcome::failed;
      if (!lost || engine == nullptr || !engine->is_ours) continue;
      std::cerr << "oplus-bench: " << row.name << ": " << m.engine << ' ' << in_words(m) << '\n';
      wrong = true;
    }
  }
  return wrong;
}

int run(const Options& options, const std::string& command) {
  if (!options.worker.empty()) return work(options);
  if (options.list) {
    list(options);
    return 0;
  }
  const Report report =
      options.from.empty() ? measured(options, command) : read_report(options.from);
  if (!options.markdown.empty()) write_file(options.markdown, page_of(report, page_template()));
  return is_wrong(report) ? exit_wrong : 0;
}

/// In quotes where a shell would see more than a word.
std::string shell_word(const std::string& argument) {
  const bool is_plain = argument.find_first_of("*?[]{}()|&;<>$`\\\"' \t#~!^") == std::string::npos;
  return is_plain && !argument.empty() ? argument : '\'' + argument + '\'';
}

std::string command_of(int argc, char** argv) {
  std::string command = "build/release/bin/oplus-bench";
  for (int i = 1; i < argc; ++i) command += ' ' + shell_word(argv[i]);
  return command;
}

}  // namespace

}  // namespace oplus

int main(int argc, char** argv) {
  using namespace oplus;
  Options options;
  CLI::App app{
      "Measures Minkowski sums: oplus's engines beside CGAL, Clipper and Boost.Polygon, each in a "
      "process of its own, and holds their results against each other"};
  app.add_option("--rows", options.rows, "Only the rows whose whole name matches")
      ->type_name("REGEX");
  app.add_option("--engines", options.engines, "Only these, separated by commas")
      ->type_name("LIST")
      ->delimiter(',');
  app.add_option("--limit", options.limit, "Seconds that a run may take before the engine is ended")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--min-time", options.min_time,
                 "Seconds that the runs of an engine take at least, unless one takes a second")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--list", options.list, "Says which rows and engines there are");
  app.add_option("--json", options.json, "Writes what was measured")->type_name("FILE");
  app.add_option("--markdown", options.markdown, "Writes the page docs/benchmarks.md")
      ->type_name("FILE");
  app.add_option("--from", options.from, "Measures nothing, takes what --json wrote")
      ->type_name("FILE");
  app.add_flag("--engines-at-fault", options.engines_at_fault,
               "Also offers engines that crash, hang and are wrong: a test of the benchmark")
      ->group("");
  app.add_option("--worker", options.worker, "ENGINE ROW: measures in this process")
      ->expected(2)
      ->group("");
  app.footer(
      "Exit code: 0 all exact results are equal, 1 they are not or an engine of oplus was lost, 2 "
      "a request that makes no sense. A peer that crashes or is too slow is a result.");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options, command_of(argc, argv));
  } catch (const std::exception& e) {
    std::cerr << "oplus-bench: " << e.what() << '\n';
    return exit_usage;
  }
}
