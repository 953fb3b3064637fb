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
      const PlanarSet value = inner_fit(pair.p, pair.q, by_slide);
      const PlanarSet right = find_defined_operation("ifp")->compute(pair.p, pair.q);
      ++outcome.counts["inner-fit polygons"];
      outcome.counts["empty ones"] += right == PlanarSet{};
      outcome.counts["those with edges"] += !right.dangling_edges.empty();
      outcome.counts["those with points"] += !right.isolated_vertices.empty();
      outcome.counts["unbounded ones"] += right.is_unbounded;
      has_edges = has_edges || !right.dangling_edges.empty();
      has_points = has_points || !right.isolated_vertices.empty();
      if (value != right) return outcome.fail(how + ": " + difference_in_words(right, value));
    }
  }
  outcome.counts["cases with exact fits along edges"] = has_edges;
  outcome.counts["cases with exact fits at points"] = has_points;
  return outcome;
}

const Registered registered({
    .id = "fact-inner-fit",
    // A frame that is too near shows where Q has components on both sides of it.
    .sources = {{"components", 3, 9}, {"tight", 2, 3}, {"grid", 5, 2}, {"holes", 3, 1}},
    .promises = {{"cases with exact fits along edges", 20},
                 {"cases with exact fits at points", 20},
                 {"holes", 5},
                 {"several components", 30},
                 {"parallel edges", 40}},
    .kills = {"no-fit-without-a-turn", "complements-lose-their-points", "frames-are-too-near",
              "inner-fits-look-at-one-vertex"},
    .cases = 50,
    .check = check,
});

}  // namespace

}  // namespace oplus
