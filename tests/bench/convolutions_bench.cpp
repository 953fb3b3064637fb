// SPDX-License-Identifier: GPL-3.0-or-later
// Cycle tracing, O(n + m + K), beside all pairs, O(nm) (thesis, Section 3.2.1).
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/generators/family.hpp"
#include "properties/generators/polygons.hpp"
#include "tests/bench/comparisons.hpp"

namespace oplus {

namespace {

void compare(const std::string& name, const Region& p, const Region& q) {
  const auto pair = std::make_shared<const Summands>(Summands{p, q});
  benchmark::RegisterBenchmark((name + "/traced").c_str(), [pair](benchmark::State& state) {
    std::size_t steps = 0;
    for (auto _ : state) steps = convolution_cycles(pair->p, pair->q).steps;
    state.counters["steps"] = static_cast<double>(steps);
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark((name + "/naive").c_str(), [pair](benchmark::State& state) {
    std::size_t segments = 0;
    for (auto _ : state) segments = convolution(pair->p, pair->q).size();
    state.counters["segments"] = static_cast<double>(segments);
  })->Unit(benchmark::kMillisecond);
}

}  // namespace

void compare_convolutions() {
  Random random(1);
  for (const std::size_t n : {50, 100, 200, 400}) {
    const std::string sizes = std::to_string(n) + "_" + std::to_string(n);
    Region convex = convex_polygon(random, n);
    compare("convolution_of_convex_" + sizes, convex, convex_polygon(random, n));
    Region star = star_polygon(random, n);
    compare("convolution_of_stars_" + sizes, star, star_polygon(random, n));
  }
}

}  // namespace oplus
