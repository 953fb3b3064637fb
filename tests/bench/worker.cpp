// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/worker.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <sstream>

#include "properties/runner/child_process.hpp"

namespace oplus {

namespace {

template <typename Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of all threads of this process.
double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

void say(const std::string& line) { std::cout << line << std::endl; }

/// Says that another run has ended, so that its limit is each run's own. Many short ones are said
/// together, lest writing be what the processor does.
class Pulse {
 public:
  void beat() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(20)) return;
    say("computing");
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void measure(PreparedPairs& pairs, double min_time, Measurement& measurement) {
  std::vector<double> computed;
  std::vector<double> evaluated;
  double total = 0;
  double worked = 0;
  Pulse pulse;
  do {
    pairs.forget();
    worked -= processor_seconds();
    computed.push_back(seconds_of([&] { pairs.compute(); }));
    worked += processor_seconds();
    if (computed.size() == 1) measurement.peak_mb = own_peak_mb();
    total += computed.back();
    pulse.beat();
    if (pairs.is_lazy())
      evaluated.push_back(computed.back() + seconds_of([&] { pairs.evaluate(); }));
    pulse.beat();
  } while (computed.back() <= long_run && (computed.size() < least_runs || total < min_time));
  measurement.runs = computed.size();
  measurement.busy = worked / total;
  measurement.seconds = median(std::move(computed));
  if (!evaluated.empty()) measurement.seconds_evaluated = median(std::move(evaluated));
}

std::string last_line(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);) last = line;
  return last;
}

std::string format(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace

void work(const BenchmarkedEngine& engine, const BenchRow& row, double min_time) {
  Measurement measurement;
  measurement.engine = engine.name;
  try {
    const std::unique_ptr<PreparedPairs> pairs = engine.prepare(row.make());
    say("prepared");
    measure(*pairs, min_time, measurement);
    say("computed");
    pairs->describe(measurement);
    say(nlohmann::ordered_json(measurement).dump());
    // What is freed at the end is nobody's business.
    std::_Exit(0);
  } catch (const NotTaken& e) {
    measurement.outcome = Outcome::not_taken;
    measurement.note = e.what();
  } catch (const std::exception& e) {
    measurement.outcome = Outcome::failed;
    measurement.note = e.what();
  }
  say(nlohmann::ordered_json(measurement)
          .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  std::_Exit(0);
}

Measurement measured_in_worker(const BenchmarkedEngine& engine, const BenchRow& row,
                               double min_time, double limit) {
  Measurement measurement;
  measurement.engine = engine.name;
  ProcessLimits limits;
  limits.seconds = limit;
  limits.a_line_at_a_time = true;
  const EndedProcess ended = run_program(
      {program_beside(""), "--worker", engine.name, row.name, "--min-time", format(min_time)},
      limits);
  measurement.peak_mb = ended.peak_mb;
  switch (ended.how) {
    case EndedProcess::How::over_time:
    case EndedProcess::How::over_output:
      measurement.outcome = Outcome::over_limit;
      measurement.note = "> " + format(limit) + " s";
      return measurement;
    case EndedProcess::How::killed_by_signal:
      measurement.outcome = Outcome::crashed;
      measurement.note = "signal " + std::to_string(ended.code);
      return measurement;
    case EndedProcess::How::exited:
      break;
  }
  const auto json = nlohmann::ordered_json::parse(last_line(ended.output), nullptr, false);
  if (ended.code == 0 && json.is_object()) return json.get<Measurement>();
  measurement.outcome = Outcome::failed;
  measurement.note = "exit code " + std::to_string(ended.code);
  return measurement;
}

}  // namespace oplus
