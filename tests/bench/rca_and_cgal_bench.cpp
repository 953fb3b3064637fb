// SPDX-License-Identifier: GPL-3.0-or-later
// rca beside CGAL's own reduced convolution, on the same pairs in one run.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "checked/rca/rca.hpp"
#include "properties/generators/fork.hpp"
#include "properties/generators/polygons.hpp"
#include "reference/io/reading.hpp"
#include "tests/bench/peers.hpp"

namespace oplus {

namespace {

Summands stars(std::size_t n, std::size_t m) {
  Random random(1);
  Region p = star_polygon(random, n);
  return {std::move(p), star_polygon(random, m)};
}

Summands published(const std::string& name) {
  const std::string part = std::string(OPLUS_DATA_DIR) + "/" + name + "_part";
  return {read_region_file(part + "1.dat").region, read_region_file(part + "2.dat").region};
}

void compare(const std::string& name, const Summands& summands) {
  const auto pair = std::make_shared<const Summands>(summands);
  const auto peer = std::make_shared<const CgalSum>(summands);
  benchmark::RegisterBenchmark((name + "/rca").c_str(), [pair](benchmark::State& state) {
    std::size_t holes = 0;
    for (auto _ : state) holes = rca(pair->p, pair->q, Boundary::closed).sum.holes.size();
    state.counters["holes"] = static_cast<double>(holes);
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark((name + "/cgal_reduced").c_str(), [peer](benchmark::State& state) {
    std::size_t holes = 0;
    for (auto _ : state) holes = peer->by_reduced_convolution();
    state.counters["holes"] = static_cast<double>(holes);
  })->Unit(benchmark::kMillisecond);
}

void register_all() {
  compare("stars_100_100", stars(100, 100));
  compare("stars_50_100", stars(50, 100));
  compare("fork_10_teeth", fork_and_l(10));
  for (const std::string name : {"fork", "comb", "stars"}) {
    if (std::filesystem::exists(std::string(OPLUS_DATA_DIR) + "/" + name + "_part1.dat"))
      compare("published_" + name, published(name));
  }
}

/// After the table, how long rca took for each unit of time that CGAL took.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.repetitions > 1 && run.aggregate_name != "median") continue;
      const std::string name = run.run_name.function_name;
      const std::size_t slash = name.rfind('/');
      seconds_[name.substr(0, slash)][name.substr(slash + 1)] = run.GetAdjustedRealTime();
    }
  }

  void Finalize() override {
    for (const auto& [pair, by_engine] : seconds_) {
      if (by_engine.contains("rca") && by_engine.contains("cgal_reduced"))
        GetOutputStream() << pair << ": rca / cgal_reduced = "
                          << by_engine.at("rca") / by_engine.at("cgal_reduced") << '\n';
    }
  }

 private:
  std::map<std::string, std::map<std::string, double>> seconds_;
};

}  // namespace

}  // namespace oplus

int main(int argc, char** argv) {
  oplus::register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  oplus::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return 0;
}
