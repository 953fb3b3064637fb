// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <utility>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/state.hpp"

namespace oplus {

namespace {

/// How many edges of each summand a cycle has.
struct Size {
  std::size_t of_p = 0;
  std::size_t of_q = 0;
};

Size size_of(const ConvolutionCycle& cycle) {
  const auto of_p = static_cast<std::size_t>(std::count_if(
      cycle.begin(), cycle.end(), [](const auto& s) { return s.origin.edge_of == Summand::P; }));
  return {of_p, cycle.size() - of_p};
}

bool is_convex(const Chain& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Point& v = chain[i];
    if (orientation(chain[previous(i, chain.size())], v, chain[next(i, chain.size())]) < 0)
      return false;
  }
  return true;
}

/// The cycles of each pair of chains.
using CyclesOfPairs = std::map<std::pair<std::size_t, std::size_t>, std::vector<Size>>;

CyclesOfPairs cycles_of_pairs(const ConvolutionCycles& traced) {
  CyclesOfPairs result;
  for (const ConvolutionCycle& cycle : traced.cycles) {
    const State first = state_before(cycle.front().origin);
    result[{first.p.chain, first.q.chain}].push_back(size_of(cycle));
  }
  return result;
}

/// What is wrong with the cycles of two chains, or empty.
std::string defect(const std::vector<Size>& cycles, const Chain& p, const Chain& q) {
  const std::size_t n = p.size(), m = q.size();
  if (std::any_of(cycles.begin(), cycles.end(),
                  [&](const Size& c) { return c.of_p % n != 0 || c.of_q % m != 0; }))
    return "a cycle does not go around each chain a whole number of times";
  if (std::none_of(cycles.begin(), cycles.end(),
                   [](const Size& c) { return c.of_p > 0 && c.of_q > 0; }))
    return "no cycle goes around both chains";
  if (is_convex(p) && is_convex(q) && cycles.size() > 1)
    return "two convex chains have more than one cycle";
  return {};
}

Outcome check(const Summands& summands) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  const CyclesOfPairs cycles = cycles_of_pairs(convolution_cycles(summands.p, summands.q));
  Outcome outcome;
  std::size_t without = 0;
  for (std::size_t a = 0; a < of_p.size(); ++a) {
    for (std::size_t b = 0; b < of_q.size(); ++b) {
      const auto of_pair = cycles.find({a, b});
      const std::vector<Size> sizes =
          of_pair == cycles.end() ? std::vector<Size>{} : of_pair->second;
      const std::string why = defect(sizes, of_p[a], of_q[b]);
      if (!why.empty()) outcome = {Outcome::Kind::fails, why, {}};
      if (std::none_of(sizes.begin(), sizes.end(), [&](const Size& c) {
            return c.of_p + c.of_q == of_p[a].size() + of_q[b].size();
          }))
        ++without;
    }
  }
  outcome.counts = {{"pairs of chains", of_p.size() * of_q.size()},
                    {"pairs of chains without a cycle of n + m segments", without}};
  return outcome;
}

const Registered registered(larger_mixture(), {.id = "corollary-4.1.9",
                                               .kills = {"cycle-ends-in-its-column"},
                                               .cases = 1500,
                                               .check = check});

}  // namespace

}  // namespace oplus
