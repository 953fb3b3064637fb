// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/operations.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/operations/by_slide.hpp"
#include "reference/oracle/operations_by_definition.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  Outcome outcome;
  bool has_edges = false, has_points = false;
  for (std::size_t kind = 0; kind < fitting_kinds; ++kind) {
    for (const bool second : {false, true}) {
      if (second && kind < 3) continue;
      const auto [how, pair] = fitting_pair(summands, kind, second);
      const MinkowskiSum value = inner_fit(pair.p, pair.q, by_slide);
      const MinkowskiSum right = find_defined_operation("ifp")->compute(pair.p, pair.q);
      ++outcome.counts["inner-fit polygons"];
      outcome.counts["empty ones"] += right == MinkowskiSum{};
      outcome.counts["those with edges"] += !right.dangling_edges.empty();
      outcome.counts["those with points"] += !right.isolated_vertices.empty();
      outcome.counts["unbounded ones"] += right.is_unbounded;
      has_edges = has_edges || !right.dangling_edges.empty();
      has_points = has_points || !right.isolated_vertices.empty();
      if (value != right) return outcome.fail(how + ": " + told_apart(right, value));
    }
  }
  outcome.counts["cases with exact fits along edges"] = has_edges;
  outcome.counts["cases with exact fits at points"] = has_points;
  return outcome;
}

const Registered registered({
    .id = "fact-inner-fit",
    .title = "Where Q fits into P: the complement of a sum of the complement",
    .statement =
        "The closed set of all x for which Q + x is a subset of P is the complement of the open sum of "
        "P's complement and -Q. Where Q fits exactly, it has edges and points without area. P and Q "
        "may be unbounded. Tried on pairs in which Q often fits, exactly too.",
    .why =
        "Q is the closure of its interior, so Q + x is a subset of P iff the interior of Q + x and the "
        "complement of P have no point in common: iff x is not in the open sum. An unbounded summand is "
        "summed in a frame that is further away than the other one is wide: what is summed with the part "
        "left out lies outside the frame's sum, or is in it anyway. The definition (docs/oracle.md) takes "
        "neither complements nor frames: it looks for a cell that is in Q + x and not in P.",
    .hypotheses = {"P and Q are valid regions, which may be unbounded"},
    .rests_on = {"section-3.2"},
    // A frame that is too near shows where Q has components on both sides of it.
    .sources = {{"components", 3, 9}, {"tight", 2, 3}, {"grid", 5, 2}, {"holes", 3, 1}},
    .promises = {{"cases with exact fits along edges", 20},
                 {"cases with exact fits at points", 20},
                 {"holes", 5},
                 {"several components", 30},
                 {"parallel edges", 40}},
    .kills = {"no-fit-without-a-turn", "complements-lose-their-points", "frames-are-too-near"},
    .cases = 60,
    .check = check,
});

}  // namespace

}  // namespace oplus
