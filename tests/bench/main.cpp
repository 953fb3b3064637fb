// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "checked/timed.hpp"
#include "properties/compare/peers/peer_table.hpp"
#include "properties/runner/child_process.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

constexpr auto help =
    R"(oplus-bench [OPTION...]: time and memory of Minkowski sums by oplus, CGAL, Clipper and Boost.Polygon
      --list            list rows and engines: cells separated by tabs
      --memory=MB       limit the memory of this process
      --limit=SECONDS   end this process (by SIGALRM) where a step takes longer: making a pair, a sum, ...
      --seed=NUMBER     of the experiments' pairs; default: 1
      --scale=NUMBER    multiplies the largest size of each experiment's family; default: 1
      --with-faults     also rows with engines that crash, hang and are wrong
A benchmark is ROW/ENGINE, such as fork_50/slide. Its counters: times in seconds, MB, sizes; its label: a digest of
an exact result, which is the same for all engines, and the area. tests/bench/table.py runs each in a process of its
own, and compares. Options of Google Benchmark:

)";

/// A run that takes longer than this, in seconds, is not repeated.
constexpr double long_run = 0.5;

double limit = 0;

/// A step that takes longer than the limit ends this process.
void begin_step() {
  const double whole = std::floor(limit);
  const ::itimerval timer{
      {}, {static_cast<time_t>(whole), static_cast<suseconds_t>(1e6 * (limit - whole))}};
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

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

using Numbers = std::map<std::string, double>;

/// An engine's work on a row. Making the pairs, and one run that shows what the result is, come first.
class Work {
 public:
  Work(const Row& row, const BenchEngine& engine) : made_(row.make()) {
    pairs_ = engine.prepare(row, made_);
    first_ = run();
    if (made_.size() == 1) {
      numbers_["m"] = static_cast<double>(vertex_count(made_[0].p));
      numbers_["n"] = static_cast<double>(vertex_count(made_[0].q));
    }
    begin_step();
    Description description;
    pairs_->describe(description);
    numbers_.insert(description.numbers().begin(), description.numbers().end());
    label_ = description.label();
  }

  void measure(benchmark::State& state) {
    Numbers total;
    for (auto _ : state) {
      const Numbers seconds = first_.at("seconds") > long_run ? first_ : run();
      state.SetIterationTime(seconds.at("seconds"));
      for (const auto& [name, value] : seconds) total[name] += value;
    }
    for (const auto& [name, value] : total)
      state.counters[name] = benchmark::Counter(value, benchmark::Counter::kAvgIterations);
    for (const auto& [name, value] : numbers_) state.counters[name] = value;
    state.SetLabel(label_);
  }

 private:
  /// Computes the results again. Only that is between the clocks.
  Numbers run() {
    begin_step();
    Numbers seconds;
    pairs_->forget();
    const double worked = processor_seconds();
    Seconds took{};
    timed(took, [&] { pairs_->compute(); });
    seconds["busy_seconds"] = processor_seconds() - worked;
    if (!numbers_.contains("peak_mb")) numbers_["peak_mb"] = own_peak_mb();
    seconds["seconds"] = took.count();
    pairs_->add_stages(seconds);
    begin_step();
    if (timed(took, [&] { return pairs_->evaluate(); }))
      seconds["seconds_evaluated"] = took.count();
    return seconds;
  }

  std::vector<Summands> made_;
  std::unique_ptr<PreparedPairs> pairs_;
  Numbers first_;
  Numbers numbers_;
  std::string label_;
};

/// Google Benchmark calls this several times for a measurement.
void measure(benchmark::State& state, const Row& row, const BenchEngine& engine) {
  static std::string measured;
  static std::unique_ptr<Work> work;
  begin_step();
  try {
    if (const std::string name = row.name + '/' + engine.name; measured != name) {
      work.reset();
      work = std::make_unique<Work>(row, engine);
      measured = name;
    }
    work->measure(state);
  } catch (const Unsupported& e) {
    state.SkipWithError((std::string("unsupported: ") + e.what()).c_str());
  } catch (const std::bad_alloc&) {
    throw;  // ends this process
  } catch (const std::exception& e) {
    state.SkipWithError((std::string("failed: ") + e.what()).c_str());
  }
  const ::itimerval none{};
  ::setitimer(ITIMER_REAL, &none, nullptr);
}

void list(const Rows& rows) {
  for (const Row& row : rows) {
    std::cout << "row\t" << row.name << '\t' << row.group << '\t' << row.what << '\t' << row.subject
              << '\t' << row.pairs << '\t';
    for (const std::string& engine : row.engines)
      std::cout << (engine == row.engines[0] ? "" : " ") << engine;
    std::cout << '\n';
  }
  for (const BenchEngine& engine : bench_engines())
    std::cout << "engine\t" << engine.name << '\t' << engine.what << '\t' << engine.kind << '\t'
              << engine.is_ours << engine.rounds << engine.is_of_all_rows << '\n';
  std::cout << "peak_mb\t" << own_peak_mb() << '\n';  // of a process that measures nothing
}

void register_all(const Rows& rows) {
  for (const Row& row : rows)
    for (const std::string& name : row.engines) {
      const auto engine = std::ranges::find_if(bench_engines(), [&](const BenchEngine& one) {
        return one.kind == row.kind && one.name == name;
      });
      benchmark::RegisterBenchmark(
          (row.name + '/' + name).c_str(),
          [&row, engine](benchmark::State& state) { measure(state, row, *engine); })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    }
}

int run(int argc, char** argv) {
  Numbers values{{"limit", 0}, {"memory", 0}, {"seed", 1}, {"scale", 1}};
  bool lists = false;
  bool with_faults = false;
  benchmark::Initialize(&argc, argv, [] {
    std::cout << help;
    benchmark::PrintDefaultHelp();
  });
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t equals = std::min(argument.find('='), argument.size());
    const auto value = values.find(argument.substr(std::min<std::size_t>(2, equals), equals - 2));
    if (argument == "--list")
      lists = true;
    else if (argument == "--with-faults")
      with_faults = true;
    else if (value == values.end() || equals == argument.size())
      throw std::invalid_argument("unknown option " + argument + "; --help shows all");
    else if (std::istringstream text(argument.substr(equals + 1));
             !(text >> value->second) || !text.eof() || value->second < 0)
      throw std::invalid_argument("invalid number: " + argument);
  }
  limit = values["limit"];
  Rows rows = benchmark_rows();
#ifndef OPLUS_CLIPPER2
  for (Row& row : experiment_rows(static_cast<std::uint64_t>(values["seed"]), values["scale"]))
    if (with_faults || row.subject != "faults") rows.push_back(std::move(row));
#endif
  if (lists) {
    list(rows);
    return 0;
  }
  benchmark::AddCustomContext("libraries", libraries_of_peers() + ", " OPLUS_BENCH_FLAGS);
  register_all(rows);
  if (const auto bytes = static_cast<rlim_t>(1e6 * values["memory"]); bytes > 0) {
    const ::rlimit most{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &most);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace

}  // namespace oplus

int main(int argc, char** argv) {
  try {
    return oplus::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "oplus-bench: out of memory\n";
  } catch (const std::exception& e) {
    std::cerr << "oplus-bench: " << e.what() << '\n';
  }
  return 2;
}
