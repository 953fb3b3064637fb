// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/measuring.hpp"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <iomanip>
#include <regex>

#include "checked/statistics.hpp"
#include "checked/timed.hpp"
#include "properties/compare/peers/method.hpp"
#include "tests/bench/numbers.hpp"
#include "tests/bench/table.hpp"

namespace oplus {

namespace {

/// Keeps the repetitions.
class Repetitions : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& reports) override {
    for (const Run& run : reports)
      if (run.run_type == Run::RT_Iteration) runs_.push_back(run);
  }

  std::size_t size() const { return runs_.size(); }

  /// The one with the median time. Requires: size() > 0.
  const Run& middle() {
    const auto middle = runs_.begin() + static_cast<std::ptrdiff_t>(runs_.size() / 2);
    std::ranges::nth_element(runs_, middle, {},
                             [](const Run& run) { return run.counters.at("seconds").value; });
    return *middle;
  }

 private:
  std::vector<Run> runs_;
};

/// Of all threads of this process, and of programs that it has run.
double processor_seconds() {
  double seconds = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    ::rusage usage{};
    ::getrusage(who, &usage);
    for (const ::timeval& time : {usage.ru_utime, usage.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

/// The times of the pairs, and the peak memory until they have been computed once.
std::map<std::string, double> timings(PreparedPairs& pairs, const std::function<void()>& beat,
                                      double min_time) {
  std::map<std::string, double> numbers;
  // forget() and evaluate() are outside of the clock.
  const auto run = [&](std::map<std::string, double>& total) {
    pairs.forget();
    const double worked = processor_seconds();
    Seconds seconds{};
    timed(seconds, [&] { pairs.compute(); });
    total["busy"] += processor_seconds() - worked;
    total["seconds"] += seconds.count();
    const double computing = seconds.count();
    if (!numbers.contains("peak_mb")) numbers["peak_mb"] = own_peak_mb();
    pairs.add_stages(total);
    beat();
    if (timed(seconds, [&] { return pairs.evaluate(); }))
      total["seconds_evaluated"] += seconds.count();
    beat();
    return computing;
  };
  std::map<std::string, double> counted;
  numbers["repetitions"] = 1;
  if (run(counted) <= long_run) {
    const auto run_often = [&](benchmark::State& state) {
      std::map<std::string, double> total;
      for (auto _ : state) state.SetIterationTime(run(total));
      for (const auto& [name, seconds] : total)
        state.counters[name] = benchmark::Counter(seconds, benchmark::Counter::kAvgIterations);
    };
    auto* const again = benchmark::RegisterBenchmark("again", run_often)->UseManualTime();
    again->Repetitions(repetitions);
    if (min_time > 0)
      again->MinTime(min_time / repetitions);
    else
      again->Iterations(1);
    Repetitions repeated;
    benchmark::RunSpecifiedBenchmarks(&repeated, "again");
    numbers["repetitions"] = static_cast<double>(repeated.size());
    for (const auto& [name, counter] : repeated.middle().counters) counted[name] = counter.value;
  }
  counted["busy"] /= counted.at("seconds");
  numbers.merge(counted);
  return numbers;
}

void write_line(std::ostream& out, const Row& row, const Measurement& m) {
  out << "  " << std::left << std::setw(16) << m.engine << std::right;
  if (!m.is_done()) out << "  " << in_words(m);
  const std::string columns =
      "ms = 1000 *.seconds; MB = 1 *.peak_mb; vertices = *.sum_vertices; holes = *.sum_holes; "
      "segments = *.segments; ms evaluated = 1000 *.seconds_evaluated; % busy = 100 *.busy";
  if (m.is_done())
    for (const Column& column :
         columns_of(std::regex_replace(columns, std::regex("\\*"), m.engine)))
      if (const std::string cell = column.cell(row); !cell.empty())
        out << std::setw(9) << cell << ' ' << column.heading;
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
                     const ProcessLimits& limits) {
  const auto work = [&](const std::function<void()>& beat) {
    if (!row.make) throw Unsupported("missing");
    const std::vector<Summands> made = row.make();
    const std::unique_ptr<PreparedPairs> pairs = engine.prepare(row, made);
    beat();
    Measurement measurement;
    measurement.numbers = timings(*pairs, beat, min_time);
    if (made.size() == 1) {
      measurement.numbers["m"] = static_cast<double>(vertex_count(made[0].p));
      measurement.numbers["n"] = static_cast<double>(vertex_count(made[0].q));
    }
    Description description;
    pairs->describe(description);
    description.write_to(measurement);
    return measurement;
  };
  Measurement measurement = measured_in_own_process(work, limits);
  measurement.engine = engine.name;
  return measurement;
}

void measure(Row& row, const std::vector<std::string>& engines, double min_time,
             const ProcessLimits& limits, std::ostream& out) {
  out << row.name << ": " << row.what << std::endl;
  for (const std::string& name : engines) {
    if (std::ranges::find(row.engines, name) == row.engines.end()) continue;
    row.measurements.push_back(
        measured(*find_bench_engine(row.subject, name), row, min_time, limits));
    write_line(out, row, row.measurements.back());
  }
  write_agreement(out, row);
}

}  // namespace oplus
