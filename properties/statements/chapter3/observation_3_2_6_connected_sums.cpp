// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_by_loops.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

bool is_simple(const Region& region) { return chains(region).size() == 1; }

std::string disconnected(const MinkowskiSum& sum) {
  const std::size_t components = region_of(sum).components.size();
  if (sum.outer.size() == 1 && components == 1) return "";
  return "the sum has " + std::to_string(sum.outer.size()) + " outer chains and " +
         std::to_string(components) + " components";
}

Outcome law(const Sum& sum, const Summands& summands) {
  if (is_simple(summands.p) && is_simple(summands.q))
    return unless_broken(disconnected(sum(summands.p, summands.q)));
  Outcome outcome;
  outcome.kind = Outcome::Kind::discarded;
  return outcome;
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  if (!is_simple(summands.p) || !is_simple(summands.q)) {
    outcome.kind = Outcome::Kind::discarded;
    return outcome;
  }
  const MinkowskiSum by_definition = oracle_sum(summands.p, summands.q, Boundary::closed);
  outcome.counts["holes"] = by_definition.holes.size();
  for (const MinkowskiSum& sum :
       {by_definition, sum_by_loops(summands.p, summands.q, Boundary::closed).sum}) {
    outcome.why = disconnected(sum);
    if (outcome.why.empty()) continue;
    outcome.kind = Outcome::Kind::fails;
    return outcome;
  }
  return outcome;
}

const Registered registered({
    .id = "observation-3.2.6",
    .kind = "observation",
    .title = "The sum of two simple polygons is connected",
    .statement =
        "The sum of two simple polygons has one outer chain, and any number of holes; also where "
        "it touches itself its interior is one component. So no loop inside a hole is on the "
        "boundary.",
    .why = "The interiors of the polygons are connected, hence the set of pairs of their points, "
           "and the sum is its continuous image. The degenerate features that the thesis excludes "
           "are in the closure of the interior and change nothing.",
    .hypotheses = {"P and Q are simple polygons, collinear vertices allowed"},
    .rests_on = {},
    .sources =
        {{"grid", 9, 5}, {"simple", 8, 2}, {"star", 8, 1}, {"fork", 2, 1}, {"diamond-u", 1, 1}},
    .promises = {{"reflex vertices", 20}, {"parallel edges", 30}},
    .kills = {"loops-turn-counterclockwise-most"},
    .cases = 200,
    .check = check,
    .of_implementation = of_one(law),
});

}  // namespace

}  // namespace oplus
