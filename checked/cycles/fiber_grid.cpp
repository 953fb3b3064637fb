// SPDX-License-Identifier: MIT
#include "checked/cycles/fiber_grid.hpp"

#include "checked/cycles/cycle_tracing.hpp"

namespace oplus {

FiberGrid fiber_grid(const Chain& p, const Chain& q) {
  const GridCycles traced = trace_cycles(TracedChain(p, Summand::P), TracedChain(q, Summand::Q));
  FiberGrid grid{p.size(), q.size(), traced.cycles.size(), {}};
  for (std::size_t cycle = 0; cycle < traced.cycles.size(); ++cycle) {
    auto [i, j, steps] = traced.cycles[cycle];
    for (const Summand along : steps) {
      grid.edges.push_back({i, j, along, cycle});
      if (along == Summand::P)
        i = next(i, grid.n);
      else
        j = next(j, grid.m);
    }
  }
  return grid;
}

}  // namespace oplus
