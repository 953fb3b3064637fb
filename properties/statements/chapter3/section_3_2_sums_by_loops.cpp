// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_by_loops.hpp"
#include "properties/compare/judge.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/counted.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome check_rca(const Summands& summands) {
  const JudgedPair result = judged({"", summands}, {.engines = checked_engines()});
  Outcome outcome;
  if (result.right) {
    const PlanarSet& open = result.right->open;
    outcome.counts["sums with holes"] = !result.right->closed.holes.empty();
    outcome.counts["open sums with low-dimensional features"] =
        !open.dangling_edges.empty() || !open.isolated_vertices.empty();
  }
  for (const JudgedSum& sum : result.sums) {
    if (!sum.wrong) continue;
    return outcome.fail(sum.engine + ": " + sum.wrong->failure.what, sum.wrong->failure.witness);
  }
  return outcome;
}

const Registered section_3_2({
    .id = "section-3.2",
    .sources = {{"grid", 8, 4},
                {"tight", 6, 3},
                {"holes", 5, 2},
                {"components", 5, 2},
                {"islands", 2, 2},
                {"fork", 3, 1},
                {"diamond-u", 1, 1},
                {"simple", 8, 1}},
    .promises = usual_promises(),
    .kills = {"candidates-need-no-hole-test", "slide-turns-counterclockwise-most",
              "touching-points-are-not-tested", "weak-intersections-never-meet"},
    .cases = 100,
    .check = check_rca,
});

bool are_simple(const Summands& summands) {
  return chains(summands.p).size() == 1 && chains(summands.q).size() == 1;
}

std::string disconnected(const PlanarSet& sum) {
  const std::size_t components = region_of(sum).components.size();
  if (sum.outer.size() == 1 && components == 1) return "";
  return "the sum has " + counted(sum.outer.size(), "outer chain", "outer chains") + " and " +
         counted(components, "component", "components");
}

Outcome law_of_connected_sums(const Sum& sum, const Summands& summands) {
  if (!are_simple(summands)) return {Outcome::Kind::discarded, {}, {}};
  return unless_broken(disconnected(sum(summands.p, summands.q)));
}

Outcome check_connected_sums(const Summands& summands) {
  if (!are_simple(summands)) return {Outcome::Kind::discarded, {}, {}};
  const PlanarSet by_definition = oracle_sum(summands.p, summands.q, Boundary::closed);
  Outcome outcome = unless_broken(disconnected(by_definition));
  if (outcome.kind == Outcome::Kind::holds)
    outcome =
        unless_broken(disconnected(sum_by_loops(summands.p, summands.q, Boundary::closed).sum));
  outcome.counts["holes"] = by_definition.holes.size();
  return outcome;
}

const Registered observation_3_2_6({
    .id = "observation-3.2.6",
    .sources =
        {{"grid", 9, 5}, {"simple", 8, 2}, {"star", 8, 1}, {"fork", 2, 1}, {"diamond-u", 1, 1}},
    .promises = {{"reflex vertices", 20}, {"parallel edges", 30}},
    .kills = {"loops-turn-counterclockwise-most"},
    .cases = 200,
    .check = check_connected_sums,
    .of_engine = for_one_engine(law_of_connected_sums),
});

}  // namespace

}  // namespace oplus
