// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/complement.hpp"
#include "checked/operations/operations.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/region.hpp"
#include "reference/oracle/set_by_pieces.hpp"

namespace oplus {

namespace {

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

Outcome check(const Summands& summands) {
  Outcome outcome;
  for (std::size_t kind = 0; kind < fitting_kinds; ++kind) {
    const auto [how, pair] = fitting_pair(summands, kind);
    const std::string fault = broken(pair.p, pair.q, kind == 3);
    ++outcome.counts["openings and closings"];
    if (!fault.empty()) return outcome.fail(how + ": " + fault);
  }
  return outcome;
}

const Registered registered({
    .id = "law-opening-closing",
    .sources = {{"tight", 2, 4}, {"grid", 5, 4}, {"holes", 4, 2}, {"components", 3, 2}},
    .promises = {{"holes", 10}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"closing-does-not-erode", "openings-lose-exact-fits"},
    .cases = 40,
    .check = check,
});

}  // namespace

}  // namespace oplus
