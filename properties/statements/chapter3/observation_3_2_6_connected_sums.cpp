// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_by_loops.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/counted.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

bool are_simple(const Summands& summands) {
  return chains(summands.p).size() == 1 && chains(summands.q).size() == 1;
}

std::string disconnected(const PlanarSet& sum) {
  const std::size_t components = region_of(sum).components.size();
  if (sum.outer.size() == 1 && components == 1) return "";
  return "the sum has " + counted(sum.outer.size(), "outer chain", "outer chains") + " and " +
         counted(components, "component", "components");
}

Outcome law(const Sum& sum, const Summands& summands) {
  if (!are_simple(summands)) return {Outcome::Kind::discarded, {}, {}};
  return unless_broken(disconnected(sum(summands.p, summands.q)));
}

Outcome check(const Summands& summands) {
  if (!are_simple(summands)) return {Outcome::Kind::discarded, {}, {}};
  const PlanarSet by_definition = oracle_sum(summands.p, summands.q, Boundary::closed);
  Outcome outcome = unless_broken(disconnected(by_definition));
  if (outcome.kind == Outcome::Kind::holds)
    outcome =
        unless_broken(disconnected(sum_by_loops(summands.p, summands.q, Boundary::closed).sum));
  outcome.counts["holes"] = by_definition.holes.size();
  return outcome;
}

const Registered registered({
    .id = "observation-3.2.6",
    .sources =
        {{"grid", 9, 5}, {"simple", 8, 2}, {"star", 8, 1}, {"fork", 2, 1}, {"diamond-u", 1, 1}},
    .promises = {{"reflex vertices", 20}, {"parallel edges", 30}},
    .kills = {"loops-turn-counterclockwise-most"},
    .cases = 200,
    .check = check,
    .of_engine = for_one_engine(law),
});

}  // namespace

}  // namespace oplus
