// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "checked/engines.hpp"
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

struct OwnSums {
  using Input = Summands;
  using Sum = ComputedSum;

  Engine engine;
  Boundary boundary;
  EngineOptions options;

  const Summands& converted(const Summands& pair) const { return pair; }
  ComputedSum sum(const Summands& pair) const {
    return engine.compute(pair.p, pair.q, boundary, options);
  }

  /// `time` is that of all stages but the output, as in the thesis.
  void add_stages(const Summands&, const ComputedSum& computed,
                  std::map<std::string, double>& seconds) const {
    each_statistic<Seconds>(computed, [&](const std::string& name, const Seconds& duration) {
      seconds[name] += duration.count();
      if (name != "output") seconds["time"] += duration.count();
    });
  }

  void describe(const Summands&, const ComputedSum& computed, Description& description) const {
    each_statistic<std::size_t>(computed, [&](const std::string& name, std::size_t count) {
      description.count(name, count);
    });
    description.add(computed.sum, Arithmetic::exact);
  }

 private:
  template <typename Unit, typename Use>
  static void each_statistic(const ComputedSum& computed, Use use) {
    for (const Statistic& statistic : computed.statistics)
      if (const auto name = short_names.find(statistic.name); name != short_names.end())
        if (const Unit* value = std::get_if<Unit>(&statistic.value)) use(name->second, *value);
  }
};

BenchEngine bench_engine(const std::string& name, const std::string& what, const Engine& engine,
                         unsigned threads = 1) {
  return {.name = name, .what = what, .prepare = each_pair([=](const Row& row) {
                                        return OwnSums{engine, row.boundary, {.threads = threads}};
                                      })};
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
    BenchEngine engine = bench_engine(name, what, {.name = name, .compute = compute});
    engine.is_ours = false;
    engine.is_at_fault = true;
    return engine;
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
