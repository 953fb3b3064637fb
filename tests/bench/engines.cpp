// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/engine.hpp"

namespace oplus {

const std::vector<BenchEngine>& bench_engines() {
  static const std::vector<BenchEngine> all = [] {
    std::vector<BenchEngine> made;
#ifdef OPLUS_CLIPPER2  // the newest libraries' program
    for (auto* list : {peer_engines})
#else
    for (auto* list : {own_engines, peer_engines, command_engines, convolution_engines,
                       hole_test_engines, distance_engines, engines_at_fault})
#endif
      for (BenchEngine& engine : list()) made.push_back(std::move(engine));
    return made;
  }();
  return all;
}

}  // namespace oplus
