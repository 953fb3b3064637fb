// SPDX-License-Identifier: GPL-3.0-or-later
// The engines beside CGAL's own reduced convolution, on the same pairs in one run.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>
#include <string>

#include "checked/loops/sum_by_loops.hpp"
#include "checked/rca/rca.hpp"
#include "checked/winding/sum_by_winding_numbers.hpp"
#include "properties/generators/fork.hpp"
#include "properties/generators/polygons.hpp"
#include "reference/io/reading.hpp"
#include "tests/bench/comparisons.hpp"
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

using Compute = MinkowskiSum (*)(const Summands&);

void add(const std::string& pair, const std::string& engine,
         const std::shared_ptr<const Summands>& summands, Compute compute) {
  benchmark::RegisterBenchmark((pair + "/" + engine).c_str(), [summands,
                                                               compute](benchmark::State& state) {
    std::size_t holes = 0;
    for (auto _ : state) holes = compute(*summands).holes.size();
    state.counters["holes"] = static_cast<double>(holes);
  })->Unit(benchmark::kMillisecond);
}

void compare(const std::string& name, const Summands& summands) {
  const auto pair = std::make_shared<const Summands>(summands);
  add(name, "rca", pair, [](const Summands& s) { return rca(s.p, s.q, Boundary::closed).sum; });
  add(name, "loops", pair,
      [](const Summands& s) { return sum_by_loops(s.p, s.q, Boundary::closed).sum; });
  add(name, "winding", pair,
      [](const Summands& s) { return sum_by_winding_numbers(s.p, s.q, Boundary::closed).sum; });
  const auto peer = std::make_shared<const CgalSum>(summands);
  benchmark::RegisterBenchmark((name + "/cgal_reduced").c_str(), [peer](benchmark::State& state) {
    std::size_t holes = 0;
    for (auto _ : state) holes = peer->by_reduced_convolution();
    state.counters["holes"] = static_cast<double>(holes);
  })->Unit(benchmark::kMillisecond);
}

}  // namespace

void compare_sums() {
  compare("stars_100_100", stars(100, 100));
  compare("stars_50_100", stars(50, 100));
  compare("fork_10_teeth", fork_and_l(10));
  for (const std::string name : {"fork", "comb", "stars"}) {
    if (std::filesystem::exists(std::string(OPLUS_DATA_DIR) + "/" + name + "_part1.dat"))
      compare("published_" + name, published(name));
  }
}

}  // namespace oplus
