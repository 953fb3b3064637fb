// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "checked/engines.hpp"
#include "tests/bench/described_sums.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

/// What tables call an engine's statistics.
const std::map<std::string, std::string, std::less<>> short_names{
    {"segments slid along", "segments"},
    {"segments in the arrangement", "segments"},
    {"arrangement vertices", "vertices"},
    {"arrangement edges", "edges"},
    {"arrangement faces", "faces"},
    {"hole tests", "hole_tests"},
    {"tests of low-dimensional features", "point_tests"},
    {"seconds for cycles", "cycles"},
    {"seconds for the arrangement", "arrangement"},
    {"seconds to prepare hole tests", "hierarchy"},
    {"seconds for hole tests", "hole_test"},
    {"seconds for low-dimensional features", "degenerate"},
    {"seconds for the canonical form", "output"},
};

class OwnSums : public PreparedPairs {
 public:
  OwnSums(const Engine& engine, unsigned threads, const Row& row,
          const std::vector<Summands>& pairs)
      : engine_(engine), boundary_(row.boundary), pairs_(pairs) {
    options_.threads = threads;
    sums_.reserve(pairs.size());
  }

  void compute() override {
    for (const Summands& pair : pairs_)
      sums_.push_back(engine_.compute(pair.p, pair.q, boundary_, options_));
  }

  void forget() override { sums_.clear(); }

  /// `time` is that of all stages but the output, as in the thesis.
  void add_stages(std::map<std::string, double>& seconds) const override {
    each_statistic<Seconds>([&](const std::string& name, const Seconds& duration) {
      seconds[name] += duration.count();
      if (name != "output") seconds["time"] += duration.count();
    });
  }

  void describe(Measurement& measurement) const override {
    each_statistic<std::size_t>([&](const std::string& name, std::size_t count) {
      measurement.numbers[name] += static_cast<double>(count);
    });
    std::vector<MinkowskiSum> sums;
    for (const ComputedSum& computed : sums_) sums.push_back(computed.sum);
    describe_sums(sums, false, measurement);
  }

 private:
  template <typename Unit, typename Use>
  void each_statistic(Use use) const {
    for (const ComputedSum& computed : sums_)
      for (const Statistic& statistic : computed.statistics)
        if (const auto name = short_names.find(statistic.name); name != short_names.end())
          if (const Unit* value = std::get_if<Unit>(&statistic.value)) use(name->second, *value);
  }

  Engine engine_;
  Boundary boundary_;
  EngineOptions options_;
  std::vector<Summands> pairs_;
  std::vector<ComputedSum> sums_;
};

BenchEngine bench_engine(const std::string& name, const std::string& what, const Engine& engine,
                         unsigned threads = 1, bool is_at_fault = false) {
  return {name,
          what,
          Subject::sums,
          false,
          !is_at_fault,
          [=](const Row& row, const std::vector<Summands>& pairs) {
            return std::make_unique<OwnSums>(engine, threads, row, pairs);
          },
          is_at_fault};
}

const Engine& engine_named(const std::string& name) {
  const Engine* engine = find_engine(engines(), name);
  if (engine == nullptr) throw std::logic_error("no engine is called " + name);
  return *engine;
}

}  // namespace

std::vector<BenchEngine> own_engines() {
  const auto own = [](const std::string& name) {
    const Engine& engine = engine_named(name);
    return bench_engine(name, "oplus: " + engine.what, engine);
  };
  return {own("slide"),
          bench_engine("slide2", "oplus: slide on two threads", engine_named("slide"), 2),
          own("rca"), own("winding")};
}

std::vector<BenchEngine> engines_at_fault() {
  const auto at_fault = [](const std::string& name, const std::string& what, auto compute) {
    return bench_engine(name, what, {.name = name, .compute = compute}, 1, true);
  };
  const auto crash = [](const Region&, const Region&, Boundary,
                        const EngineOptions&) -> ComputedSum { std::abort(); };
  const auto hang = [](const Region&, const Region&, Boundary,
                       const EngineOptions&) -> ComputedSum {
    while (true) ::pause();
  };
  const auto wrong = [](const Region& p, const Region& q, Boundary boundary,
                        const EngineOptions& options) {
    ComputedSum computed = engine_named("rca").compute(p, q, boundary, options);
    computed.sum.outer.at(0).at(0).x -= 1;
    return computed;
  };
  return {at_fault("crash", "aborts", crash), at_fault("hang", "never ends", hang),
          at_fault("wrong", "moves a vertex of the sum", wrong)};
}

}  // namespace oplus
