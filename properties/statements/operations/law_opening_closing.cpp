// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/complement.hpp"
#include "checked/operations/operations.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/operations/by_slide.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/region.hpp"
#include "reference/oracle/set_by_pieces.hpp"

namespace oplus {

namespace {

std::string broken(const Region& p, const Region& q, bool is_of_copies) {
  const MinkowskiSum all_of_p = canonical_sum(p);
  const MinkowskiSum open = opened(p, q, by_slide), close = closed(p, q, by_slide);
  if (!is_subset(set_by_pieces(open), set_by_pieces(p))) return "the opening is not contained in P";
  if (!is_subset(set_by_pieces(p), set_by_pieces(close))) return "the closing does not contain P";
  if (is_of_copies && open != all_of_p)
    return "the opening of a union of copies of Q is another set: " + told_apart(open, all_of_p);
  const MinkowskiSum open_again = opened(region_of(open), q, by_slide);
  if (open_again != open) return "opened twice, it is another set: " + told_apart(open, open_again);
  const MinkowskiSum close_again = closed(region_of(close), q, by_slide);
  if (close_again != close)
    return "closed twice, it is another set: " + told_apart(close, close_again);
  // The opening of the complement but for what only exact placements reach.
  const Region minus_q = reflected(q);
  const Region room = region_of(eroded(complement(p), minus_q, by_slide));
  const MinkowskiSum dual = canonical_sum(
      complement(region_of(unbounded_sum(room, minus_q, Boundary::closed, by_slide))));
  if (dual != close)
    return "the closing is not the dual of the opening: " + told_apart(close, dual);
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
    .title = "Opening and closing: contained, containing, idempotent, dual",
    .statement =
        "The opening of P by Q is a subset of P, its closing contains P, and doing either twice changes "
        "nothing. The opening of a union of copies of Q by Q is that union. The closing of P by Q is the "
        "complement of the closed sum of -Q and the erosion of P's complement by -Q.",
    .why =
        "Each Q + x inside P is inside the opening, and P ⊕ Q is the sum of the closing and Q: so the second "
        "time, the placements and the sum are those of the first. A point y is not in the closing iff some "
        "y + q is not in P ⊕ Q, that is, iff it is in a copy of -Q that is in the interior of P's complement. The "
        "last statement is the known duality of opening and closing, in closed regions: the opening of the "
        "complement also contains copies of -Q that fit exactly, which touch P, and the closing then "
        "contains them as well. A door just as wide as Q is closed by the closing of the walls, and open in "
        "the opening of the room.",
    .hypotheses = {"P and Q are valid regions, which may be unbounded"},
    .rests_on = {"law-adjoint"},
    .sources = {{"tight", 2, 4}, {"grid", 5, 4}, {"holes", 4, 2}, {"components", 3, 2}},
    .promises = {{"holes", 10}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"closing-does-not-erode", "openings-lose-exact-fits"},
    .cases = 40,
    .check = check,
});

}  // namespace

}  // namespace oplus
