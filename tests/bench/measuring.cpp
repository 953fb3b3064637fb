// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/measuring.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iomanip>

#include "properties/compare/peers/method.hpp"
#include "properties/runner/child_process.hpp"
#include "tests/bench/numbers.hpp"

namespace oplus {

namespace {

/// Keeps the repetitions that were run.
class Repetitions : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& reports) override {
    for (const Run& run : reports)
      if (run.run_type == Run::RT_Iteration) runs_.push_back(run);
  }

  std::size_t size() const { return runs_.size(); }

  /// The one whose time is in the middle. Requires: there is one.
  const Run& middle() {
    const auto middle = runs_.begin() + static_cast<std::ptrdiff_t>(runs_.size() / 2);
    std::nth_element(runs_.begin(), middle, runs_.end(), [](const Run& a, const Run& b) {
      return a.counters.at("seconds").value < b.counters.at("seconds").value;
    });
    return *middle;
  }

 private:
  std::vector<Run> runs_;
};

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

class Timing {
 public:
  Timing(PreparedPairs& pairs, const std::function<void()>& beat,
         std::map<std::string, double>& numbers)
      : pairs_(pairs), beat_(beat), numbers_(numbers) {}

  void measure(double min_time) {
    Repetitions first;
    benchmark::RegisterBenchmark("first", *this)->UseManualTime()->Iterations(1);
    benchmark::RunSpecifiedBenchmarks(&first, "first");
    const bool is_long = first.middle().counters.at("seconds") > long_run;
    Repetitions repeated;
    if (!is_long) {
      auto* const again = benchmark::RegisterBenchmark("again", *this)->UseManualTime();
      again->Repetitions(repetitions);
      if (min_time > 0)
        again->MinTime(min_time / repetitions);
      else
        again->Iterations(1);
      benchmark::RunSpecifiedBenchmarks(&repeated, "again");
    }
    Repetitions& counted = is_long ? first : repeated;
    numbers_["repetitions"] = static_cast<double>(counted.size());
    for (const auto& [name, counter] : counted.middle().counters) numbers_[name] = counter.value;
    numbers_["busy"] /= numbers_.at("seconds");
  }

  /// What forgets and what evaluates is outside of the clock.
  void operator()(benchmark::State& state) const {
    std::map<std::string, double> total;
    for (auto _ : state) {
      pairs_.forget();
      const double worked = processor_seconds();
      const double seconds = seconds_of([&] { pairs_.compute(); });
      total["busy"] += processor_seconds() - worked;
      total["seconds"] += seconds;
      state.SetIterationTime(seconds);
      if (!numbers_.contains("peak_mb")) numbers_["peak_mb"] = own_peak_mb();
      pairs_.add_stages(total);
      beat_();
      bool is_lazy = false;
      const double evaluating = seconds_of([&] { is_lazy = pairs_.evaluate(); });
      if (is_lazy) total["seconds_evaluated"] += seconds + evaluating;
      beat_();
    }
    for (const auto& [name, seconds] : total)
      state.counters[name] = benchmark::Counter(seconds, benchmark::Counter::kAvgIterations);
  }

 private:
  PreparedPairs& pairs_;
  const std::function<void()>& beat_;
  std::map<std::string, double>& numbers_;
};

/// Less than that, and other programs were in the way.
constexpr double well_busy = 0.95;

void write_line(std::ostream& out, const Measurement& m) {
  out << "  " << std::left << std::setw(14) << m.engine << std::right;
  if (!m.is_done()) {
    out << "  " << in_words(m) << std::endl;
    return;
  }
  const auto write_number = [&](const std::string& name, double factor, int width,
                                const std::string& unit) {
    if (const auto value = m.number(name))
      out << std::setw(width) << three_digits(factor * *value) << ' ' << unit;
  };
  const auto write_count = [&](const std::string& name, int width, const std::string& unit) {
    const auto count = static_cast<std::size_t>(m.number(name).value_or(0));
    if (count > 0) out << std::setw(width) << with_thousands(count) << ' ' << unit;
  };
  write_number("seconds", 1000, 10, "ms");
  write_number("peak_mb", 1, 10, "MB");
  write_count("sum_vertices", 9, "vertices");
  write_count("sum_holes", 8, "holes");
  write_count("segments", 9, "segments");
  write_number("seconds_evaluated", 1000, 10, "ms evaluated");
  if (m.number("busy") < well_busy) write_number("busy", 100, 10, "% of a processor");
  out << std::endl;
}

void write_agreement(std::ostream& out, const Row& row) {
  const std::string disagreement = agreement_of(row).disagreement;
  if (!disagreement.empty()) out << "  DISAGREEMENT: " << disagreement << std::endl;
  for (const Measurement& m : row.measurements)
    if (const auto error = row.number(m.engine + ".relative_area_error"); error && m.digest.empty())
      out << "  " << m.engine << ": area off by " << power_of_ten(*error) << " of it, "
          << m.number("sum_holes").value_or(0) << " holes of "
          << row.number("sum_holes").value_or(0) << std::endl;
}

}  // namespace

Measurement measured(const BenchEngine& engine, const Row& row, double min_time,
                     const MeasuringLimits& limits) {
  const auto work = [&](const std::function<void()>& beat) {
    if (!row.make) throw NotTaken("missing");
    const std::vector<Summands> made = row.make();
    const std::unique_ptr<PreparedPairs> pairs = engine.prepare(row, made);
    beat();
    Measurement measurement;
    Timing(*pairs, beat, measurement.numbers).measure(min_time);
    if (made.size() == 1) {
      measurement.numbers["m"] = static_cast<double>(vertex_count(made[0].p));
      measurement.numbers["n"] = static_cast<double>(vertex_count(made[0].q));
    }
    pairs->describe(measurement);
    return measurement;
  };
  Measurement measurement = measured_in_own_process(work, limits);
  measurement.engine = engine.name;
  return measurement;
}

void measure(Row& row, const std::vector<std::string>& engines, double min_time,
             const MeasuringLimits& limits, std::ostream& out) {
  out << row.name << ": " << row.what << std::endl;
  for (const std::string& name : engines) {
    if (std::find(row.engines.begin(), row.engines.end(), name) == row.engines.end()) continue;
    row.measurements.push_back(
        measured(*find_bench_engine(row.subject, name), row, min_time, limits));
    write_line(out, row.measurements.back());
  }
  write_agreement(out, row);
}

}  // namespace oplus
