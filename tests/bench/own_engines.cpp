// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cstdlib>

#include "checked/arrangement/rca.hpp"
#include "checked/engines/engines.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/verify.hpp"
#include "reference/chains/region_of.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

/// The names of statistics in tables.
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

using Computing = decltype(Engine::compute);

struct OwnSums {
  using Input = Summands;
  using Sum = ComputedSum;

  Computing compute;
  Boundary boundary;
  EngineOptions options;

  const Summands& converted(const Summands& pair) const { return pair; }
  ComputedSum sum(const Summands& pair) const { return compute(pair.p, pair.q, boundary, options); }

  /// `time` is that of all stages except the output, as in the thesis.
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
    description.add(computed.sum);
  }

 private:
  template <typename Unit, typename Use>
  static void each_statistic(const ComputedSum& computed, Use use) {
    for (const Statistic& statistic : computed.statistics)
      if (const auto name = short_names.find(statistic.name); name != short_names.end())
        if (const Unit* value = std::get_if<Unit>(&statistic.value)) use(name->second, *value);
  }
};

BenchEngine bench_engine(const std::string& name, const std::string& what, const Computing& compute,
                         unsigned threads = 1) {
  return {.name = name, .what = what, .prepare = each_pair([=](const Row& row) {
                                        return OwnSums{compute, row.boundary, {.threads = threads}};
                                      })};
}

/// The open sum, of which nothing is compared: the other engines of a row compute the closed one.
struct OpenSums : OwnSums {
  void describe(const Summands&, const ComputedSum& computed, Description& description) const {
    description.count("sum_dangling", computed.sum.dangling_edges.size());
    description.count("sum_isolated", computed.sum.isolated_vertices.size());
  }
};

/// Whether slide's sum is right.
struct Verifying {
  struct Input {
    const Summands& pair;
    ClaimedSum sum;
  };
  using Sum = Verdict;

  Input converted(const Summands& pair) const {
    return {pair, given(slide_sum(pair.p, pair.q, Boundary::closed).sum)};
  }
  Verdict sum(const Input& input) const {
    return verify(input.pair.p, input.pair.q, Boundary::closed, input.sum);
  }
  void describe(const Input&, const Verdict& verdict, Description& description) const {
    description.add(verdict.right);
  }
};

BenchEngine at_fault(const std::string& name, const std::string& what, const Computing& compute) {
  BenchEngine engine = bench_engine(name, what, compute);
  engine.is_ours = false;
  engine.is_of_all_rows = false;
  return engine;
}

}  // namespace

std::vector<BenchEngine> own_engines() {
  std::vector<BenchEngine> own;
  for (const Engine& engine : engines()) {
    if (engine.name == "loops") continue;  // rca's arrangement, with more work on it
    own.push_back(bench_engine(engine.name, engine.what, engine.compute));
    own.back().is_of_all_rows = engine.has_threads;
    if (!engine.has_threads) continue;
    own.push_back(
        bench_engine(engine.name + '2', engine.name + " on two threads", engine.compute, 2));
    own.back().is_of_all_rows = false;
  }
  own.push_back({.name = "slide-open",
                 .what = "slide, the open sum",
                 .prepare = each_pair([](const Row&) {
                   return OpenSums{{slide_sum, Boundary::open, {}}};
                 })});
  own.push_back({.name = "verify",
                 .what = "verify, asked about slide's sum",
                 .prepare = each_pair([](const Row&) { return Verifying(); })});
  return own;
}

std::vector<BenchEngine> engines_at_fault() {
  const auto wrong = [](const Region& p, const Region& q, Boundary boundary,
                        const EngineOptions& options) {
    ComputedSum computed = rca(p, q, boundary, options);
    computed.sum.outer.at(0).at(0).x -= 1;
    return computed;
  };
  return {at_fault("crash", "aborts", [](auto&&...) -> ComputedSum { std::abort(); }),
          at_fault("hang", "never ends",
                   [](auto&&...) -> ComputedSum {
                     while (true) ::pause();
                   }),
          at_fault("wrong", "moves a vertex of the sum", wrong)};
}

}  // namespace oplus
