// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "tests/bench/comparisons.hpp"

namespace oplus {

namespace {

/// After the table, how long each took for each unit of time that its peer took.
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
    for (const auto& [subject, by_who] : seconds_) {
      for (const std::string peer : {"cgal_reduced", "naive"}) {
        const auto of_peer = by_who.find(peer);
        if (of_peer == by_who.end()) continue;
        for (const auto& [who, seconds] : by_who) {
          if (who != peer)
            GetOutputStream() << subject << ": " << who << " / " << peer << " = "
                              << seconds / of_peer->second << '\n';
        }
      }
    }
  }

 private:
  std::map<std::string, std::map<std::string, double>> seconds_;
};

}  // namespace

}  // namespace oplus

int main(int argc, char** argv) {
  oplus::compare_sums();
  oplus::compare_convolutions();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  oplus::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return 0;
}
