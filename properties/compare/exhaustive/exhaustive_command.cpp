// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/exhaustive/exhaustive_command.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/engines.hpp"
#include "properties/compare/differential_report.hpp"
#include "properties/compare/exhaustive/exhaustive_run.hpp"
#include "properties/compare/shard.hpp"
#include "properties/runner/checked_engines.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

volatile std::sig_atomic_t interrupted = 0;

struct Settings {
  Scope scope;
  std::string shard = "1/1";
  std::vector<std::string> engines;
  std::string resume;
  std::string report;
  bool json = false;
  unsigned threads = std::max(std::thread::hardware_concurrency(), 1U);
  std::size_t most_shrunk = 3;
  std::string out = "oplus-findings";
};

std::vector<Engine> chosen_engines(const std::vector<std::string>& names) {
  std::vector<Engine> chosen = checked_engines();
  std::erase_if(chosen, [&](const Engine& implementation) {
    return !names.empty() &&
           std::find(names.begin(), names.end(), implementation.name) == names.end();
  });
  return chosen;
}

std::vector<std::string> names_of(const std::vector<Engine>& all) {
  std::vector<std::string> names;
  for (const Engine& implementation : all) names.push_back(implementation.name);
  return names;
}

/// The state to go on from: that of the file where there is one.
std::optional<ExhaustiveState> first_state(const Settings& settings,
                                           const std::vector<std::string>& engines) {
  ExhaustiveState state;
  state.scope = settings.scope;
  state.engines = engines;
  if (settings.resume.empty() || !std::filesystem::exists(settings.resume)) return state;
  ExhaustiveState kept = state_of_json(
      text_of_file(settings.resume, "the state of a run of exhaustive"), settings.resume);
  if (kept.scope != state.scope || kept.engines != state.engines) {
    std::cerr << "oplus-check: " << settings.resume
              << " is the state of a run with other --grid, --vertices, --shard or --engine\n";
    return std::nullopt;
  }
  if (!speech().quiet)
    std::cerr << "exhaustive: going on after " << kept.done << " of " << kept.pairs << " pairs\n";
  return kept;
}

void print(const ExhaustiveState& state) {
  std::ostringstream text;
  text << state.polygons << " polygons of 3 to " << state.scope.most_vertices << " vertices on "
       << state.scope.side << " x " << state.scope.side << " points; shard " << state.scope.shard
       << " of " << state.scope.shards << ": " << state.done << " of " << state.pairs << " pairs\n"
       << "with holes in the sum " << state.holes_in_sum << ", with low-dimensional features "
       << state.low_dimensional_features << ", with overlapping segments "
       << state.overlapping_segments << '\n'
       << "digest of all sums " << state.digest.to_string() << '\n'
       << state.done << " pairs compared, closed and open, " << state.disagreed
       << " with a disagreement\n";
  std::cout << with_painted_verdict(text.str(), state.disagreed == 0 ? Paint::good : Paint::bad,
                                    std::cout);
}

/// Says every few seconds how far the run is and how long it will take.
class Estimate {
 public:
  explicit Estimate(std::size_t done) : done_before_(done) {}

  void operator()(const ExhaustiveState& state) {
    const auto now = Clock::now();
    if (now - said_ < std::chrono::seconds(5) && state.done < state.pairs) return;
    said_ = now;
    if (speech().quiet) return;
    const std::chrono::duration<double> taken = now - start_;
    const double left = taken.count() / static_cast<double>(state.done - done_before_) *
                        static_cast<double>(state.pairs - state.done);
    std::cerr << "exhaustive: " << state.done << " of " << state.pairs << " pairs, "
              << static_cast<long>(left) << " s left" << std::endl;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t done_before_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point said_ = start_;
};

int exhaustive(Settings settings) {
  const std::optional<Shard> shard = shard_of(settings.shard);
  if (!shard) {
    say_error(no_shard(settings.shard));
    return 2;
  }
  settings.scope.shard = shard->index;
  settings.scope.shards = shard->of;
  const std::vector<Engine> checked = chosen_engines(settings.engines);
  const std::optional<ExhaustiveState> first = first_state(settings, names_of(checked));
  if (!first) return 2;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  Estimate estimate(first->done);
  std::size_t shrunk = 0;
  const ExhaustiveState state = run_exhaustively(
      *first, checked, settings.threads,
      {[&](const ExhaustiveState& now) {
         estimate(now);
         if (!settings.resume.empty()) write_file(settings.resume, to_json(now));
       },
       [] { return interrupted != 0; },
       [&](const std::string& name, const Summands& pair, const Disagreement& found) {
         if (shrunk++ >= settings.most_shrunk) return;
         text_output(settings.json)
             << explanation(write_disagreement(settings.out, name, shrink(pair, found, checked)));
       }});
  if (settings.json)
    std::cout << to_json(state);
  else
    print(state);
  if (!settings.report.empty()) write_file(settings.report, to_json(state));
  if (state.disagreed > 0) return 1;
  return state.done == state.pairs ? 0 : 5;
}

}  // namespace

void add_exhaustive_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "exhaustive", "Compare engines with the oracle on every pair of small grid polygons");
  const auto settings = std::make_shared<Settings>();
  command->add_option("--grid", settings->scope.side, "Points along a side of the grid")
      ->check(CLI::Range(2, 16))
      ->capture_default_str();
  command->add_option("--vertices", settings->scope.most_vertices, "The most vertices of a polygon")
      ->check(CLI::Range(3, 16))
      ->capture_default_str();
  command->add_option("--shard", settings->shard, "The I-th of N parts, each about as large")
      ->type_name("I/N")
      ->capture_default_str();
  command->add_option("--engine", settings->engines, "The engine to check; may be repeated")
      ->type_name("NAME")
      ->check(CLI::IsMember(names_of(engines())));
  command
      ->add_option("--resume", settings->resume,
                   "Keep the state in this file, and go on from it where it exists")
      ->type_name("FILE");
  command->add_option("--report", settings->report, "Write the result as JSON")->type_name("FILE");
  command->add_flag("--json", settings->json, "Print the result as JSON (docs/json.md)");
  command->add_option("--threads", settings->threads, "Pairs at a time; default: one a core")
      ->check(CLI::Range(1, 1024));
  command->add_option("--shrink", settings->most_shrunk, "Shrink at most so many disagreements")
      ->capture_default_str();
  command->add_option("--out", settings->out, "Folder for disagreements")
      ->type_name("DIR")
      ->capture_default_str();
  command->footer(
      "Pairs are taken up to what keeps a sum: exchange, translations, the square's symmetries.\n"
      "\n"
      "Example:\n"
      "  oplus-check exhaustive --grid 3 --vertices 5 --shard 1/4 --resume part1.json\n"
      "\n"
      "Exit codes:\n"
      "  0  all agree\n"
      "  1  a disagreement\n"
      "  2  bad input or a request that makes no sense\n"
      "  5  interrupted; the same command goes on where --resume was given");
  command->callback([settings, &exit_code] { exit_code = exhaustive(*settings); });
}

}  // namespace oplus
