// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/loops/sum_by_loops.hpp"
#include "properties/runner/registry.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

bool is_simple(const Region& region) { return chains(region).size() == 1; }

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
    if (sum.outer.size() == 1 && region_of(sum).components.size() == 1) continue;
    outcome.kind = Outcome::Kind::fails;
    outcome.why = "the sum has " + std::to_string(sum.outer.size()) + " outer chains and " +
                  std::to_string(region_of(sum).components.size()) + " components";
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
    .file = __FILE__,
    .check = check,
});

}  // namespace

}  // namespace oplus
