// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/complement.hpp"
#include "checked/operations/operations.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"
#include "reference/oracle/operations_by_definition.hpp"
#include "reference/oracle/set_by_pieces.hpp"

namespace oplus {

namespace {

Outcome check_inner_fit(const Summands& summands) {
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

const Registered fact_inner_fit({
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
    .check = check_inner_fit,
});

/// Regions S, of which some are in the placements and some are not: all of them that have area, the same
/// moved, and P and Q themselves.
std::vector<Region> tried(const PlanarSet& placements, const Summands& pair) {
  std::vector<Region> all = {pair.p, pair.q, reflected(pair.q)};
  const Region fits = region_of(regularized(placements));
  if (fits.components.empty()) return all;
  all.push_back(fits);
  all.push_back({{fits.components.back()}});
  all.push_back(translated(fits, {Rational(1, 2), 0}));
  all.push_back(translated(fits, {0, -1}));
  return all;
}

Outcome check_adjoint(const Summands& summands) {
  Outcome outcome;
  for (std::size_t kind = 0; kind < fitting_kinds; ++kind) {
    const auto [how, pair] = fitting_pair(summands, kind);
    const PlanarSet placements = inner_fit(pair.p, pair.q, by_slide);
    for (const Region& s : tried(placements, pair)) {
      const PlanarSet sum = unbounded_sum(s, pair.q, Boundary::closed, by_slide);
      if (sum != regularized(sum)) return outcome.fail(how + ": S ⊕ Q is no region");
      const bool sum_fits = is_subset(set_by_pieces(sum), set_by_pieces(pair.p));
      const bool is_among = is_subset(set_by_pieces(s), set_by_pieces(placements));
      ++outcome.counts[sum_fits ? "regions whose sum is in P" : "regions whose sum is not in P"];
      if (sum_fits != is_among)
        return outcome.fail(how + (sum_fits
                                       ? ": S ⊕ Q is in P, and S is not among the placements"
                                       : ": S is among the placements, and S ⊕ Q is not in P"));
    }
  }
  return outcome;
}

const Registered law_adjoint({
    .id = "law-adjoint",
    .sources = {{"tight", 2, 4}, {"grid", 5, 4}, {"holes", 4, 2}, {"components", 3, 2}},
    .promises = {{"holes", 10}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"closed-sums-are-open", "no-fit-without-a-turn"},
    .cases = 40,
    .check = check_adjoint,
});

std::string broken(const Region& p, const Region& q, bool is_of_copies) {
  const PlanarSet all_of_p = canonical_sum(p);
  const PlanarSet open = opened(p, q, by_slide), close = closed(p, q, by_slide);
  if (!is_subset(set_by_pieces(open), set_by_pieces(p))) return "the opening is not contained in P";
  if (!is_subset(set_by_pieces(p), set_by_pieces(close))) return "the closing does not contain P";
  if (is_of_copies && open != all_of_p)
    return "the opening of a union of copies of Q is another set: " +
           difference_in_words(open, all_of_p);
  const PlanarSet open_again = opened(region_of(open), q, by_slide);
  if (open_again != open)
    return "opened twice, it is another set: " + difference_in_words(open, open_again);
  const PlanarSet close_again = closed(region_of(close), q, by_slide);
  if (close_again != close)
    return "closed twice, it is another set: " + difference_in_words(close, close_again);
  // The opening of the complement but for what only exact placements reach.
  const Region minus_q = reflected(q);
  const Region room = region_of(eroded(complement(p), minus_q, by_slide));
  const PlanarSet dual = canonical_sum(
      complement(region_of(unbounded_sum(room, minus_q, Boundary::closed, by_slide))));
  if (dual != close)
    return "the closing is not the dual of the opening: " + difference_in_words(close, dual);
  return "";
}

Outcome check_opening_closing(const Summands& summands) {
  Outcome outcome;
  for (std::size_t kind = 0; kind < fitting_kinds; ++kind) {
    const auto [how, pair] = fitting_pair(summands, kind);
    const std::string fault = broken(pair.p, pair.q, kind == 3);
    ++outcome.counts["openings and closings"];
    if (!fault.empty()) return outcome.fail(how + ": " + fault);
  }
  return outcome;
}

const Registered law_opening_closing({
    .id = "law-opening-closing",
    .sources = {{"tight", 2, 4}, {"grid", 5, 4}, {"holes", 4, 2}, {"components", 3, 2}},
    .promises = {{"holes", 10}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"closing-does-not-erode", "openings-lose-exact-fits"},
    .cases = 40,
    .check = check_opening_closing,
});

}  // namespace

}  // namespace oplus
