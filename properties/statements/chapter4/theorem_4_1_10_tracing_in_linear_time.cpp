// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/state.hpp"

namespace oplus {

namespace {

/// Whether a cycle has a state in every row, or one in every column, of its fiber grid.
bool crosses_the_grid(const ConvolutionCycle& cycle, const std::vector<Chain>& of_p,
                      const std::vector<Chain>& of_q) {
  std::set<VertexIndex> of_p_met, of_q_met;
  for (const ConvolutionSegment& s : cycle) {
    const State state = state_before(s.origin);
    of_p_met.insert(state.p);
    of_q_met.insert(state.q);
  }
  const State first = state_before(cycle.front().origin);
  return of_p_met.size() == of_p[first.p.chain].size() ||
         of_q_met.size() == of_q[first.q.chain].size();
}

Outcome check(const Summands& summands) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  const std::size_t n = vertex_count(summands.p), m = vertex_count(summands.q);
  const std::size_t k = convolution(summands.p, summands.q).size();
  const auto [cycles, steps] = convolution_cycles(summands.p, summands.q);
  Outcome outcome;
  if (n == 0 || m == 0) return {Outcome::Kind::discarded, "a summand is empty", {}};
  outcome.counts = {{"steps", steps}, {"segments", k}, {"states of all grids", n * m}};
  for (const ConvolutionCycle& cycle : cycles)
    if (!crosses_the_grid(cycle, of_p, of_q))
      outcome.why = "a cycle leaves out a row and a column of its fiber grid";
  if (of_p.size() == 1 && of_q.size() == 1 && steps >= n + m + k)
    outcome.why =
        std::to_string(steps) + " steps are not less than n + m + K = " + std::to_string(n + m + k);
  if (steps >= 2 * k)
    outcome.why = std::to_string(steps) + " steps are not less than 2 K = " + std::to_string(2 * k);
  if (!outcome.why.empty()) outcome.kind = Outcome::Kind::fails;
  return outcome;
}

const Registered registered(larger_mixture(),
                            {.id = "theorem-4.1.10",
                             .kills = {"cycle-ends-in-its-column", "every-state-is-a-start"},
                             .cases = 1500,
                             .check = check});

}  // namespace

}  // namespace oplus
