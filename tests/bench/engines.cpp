// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "tests/bench/engine.hpp"

namespace oplus {

const std::vector<BenchEngine>& bench_engines() {
  static const std::vector<BenchEngine> all = [] {
    std::vector<BenchEngine> made;
    for (auto* list : {own_engines, peer_engines, command_engines, convolution_engines,
                       hole_test_engines, engines_at_fault})
      for (BenchEngine& engine : list()) made.push_back(std::move(engine));
    return made;
  }();
  return all;
}

const BenchEngine* find_bench_engine(Subject subject, const std::string& name) {
  if (subject != Subject::convolution && subject != Subject::hole_tests) subject = Subject::sums;
  const std::vector<BenchEngine>& all = bench_engines();
  const auto found = std::find_if(all.begin(), all.end(), [&](const BenchEngine& engine) {
    return engine.subject == subject && engine.name == name;
  });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace oplus
