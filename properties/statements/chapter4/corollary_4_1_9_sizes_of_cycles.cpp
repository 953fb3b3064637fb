// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <utility>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/mixture.hpp"
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

const Registered registered({
    .id = "corollary-4.1.9",
    .title = "Sizes of convolution cycles",
    .statement =
        "As printed, the corollary says that there is a cycle of size n + m; that is false "
        "(docs/findings.md, on Corollary 4.1.9). What holds: let a chain of P have n vertices and "
        "a chain of Q m vertices. Every cycle of these two has a n + b m segments with integers a "
        "and b, and for one cycle both are at least 1. So there is a cycle of at least n + m "
        "segments, and K is at least n + m. Two convex polygons have one cycle, of exactly n + m "
        "segments.",
    .why =
        "A closed walk goes around the columns a times and around the rows b times. Each "
        "direction is in s + r tangent sets of a chain, s = 1 for an outer chain, -1 for a hole, "
        "r its reflex vertices (fact-convolution-size); so the a of all cycles add up to s + r of "
        "Q's chain, at least 1, since a hole has three vertices where it turns right. A cycle "
        "with b = 0 stays in one row: all directions of P's chain are in the tangent set of one "
        "vertex of Q. They are not in a half plane, so that vertex is reflex, and none of them is "
        "in the arc that its tangent set leaves out. An outer chain has only r < 1 + r such "
        "vertices. In a hole, each direction is in the left-out arc of at least one reflex "
        "vertex, and at least two such arcs contain a direction of P, as an arc is less than half "
        "a circle; so there are at most r - 2 < r - 1 such vertices. Each such cycle has a = 1, "
        "so not all of the sum s + r comes from cycles with b = 0.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {"lemma-4.1.5", "fact-convolution-size"},
    .sources = larger_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"cycle-ends-in-its-column"},
    .cases = 1500,
    .check = check,
});

}  // namespace

}  // namespace oplus
