// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/state.hpp"

namespace oplus {

namespace {

/// What is wrong with a cycle, or empty.
std::string defect(const ConvolutionCycle& cycle, const std::vector<Chain>& of_p,
                   const std::vector<Chain>& of_q) {
  if (cycle.empty()) return "a cycle has no segment";
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const ConvolutionSegment& here = cycle[k];
    const ConvolutionSegment& after = cycle[next(k, cycle.size())];
    const std::string where = "after segment " + std::to_string(k) + " of " +
                              std::to_string(cycle.size()) + " a cycle goes on ";
    if (here.segment.target != after.segment.source) return where + "at another point";
    if (state_after(here.origin, of_p, of_q) != state_before(after.origin))
      return where + "in another state";
  }
  return {};
}

Outcome check(const Summands& summands) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  const ConvolutionCycles traced = convolution_cycles(summands.p, summands.q);
  std::set<Origin> missing;
  for (const ConvolutionSegment& s : convolution(summands.p, summands.q)) missing.insert(s.origin);
  Outcome outcome;
  outcome.counts = {{"cycles", traced.cycles.size()}, {"segments", missing.size()}};
  for (const ConvolutionCycle& cycle : traced.cycles) {
    if (outcome.why.empty()) outcome.why = defect(cycle, of_p, of_q);
    for (const ConvolutionSegment& s : cycle)
      if (missing.erase(s.origin) == 0 && outcome.why.empty())
        outcome.why = "a segment is in two cycles, or twice in one, or not in the convolution";
  }
  if (outcome.why.empty() && !missing.empty()) outcome.why = "a segment is in no cycle";
  if (!outcome.why.empty()) outcome.kind = Outcome::Kind::fails;
  return outcome;
}

const Registered registered(larger_mixture(),
                            {.id = "theorem-4.1.6",
                             .kills = {"cycle-ends-in-its-column", "edge-of-p-though-visited",
                                       "no-start-in-the-first-column"},
                             .cases = 1500,
                             .check = check});

}  // namespace

}  // namespace oplus
