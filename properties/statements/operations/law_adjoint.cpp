// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/operations.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"
#include "reference/oracle/operations_by_definition.hpp"
#include "reference/oracle/set_by_pieces.hpp"

namespace oplus {

namespace {

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

Outcome check(const Summands& summands) {
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

const Registered registered({
    .id = "law-adjoint",
    .sources = {{"tight", 2, 4}, {"grid", 5, 4}, {"holes", 4, 2}, {"components", 3, 2}},
    .promises = {{"holes", 10}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"closed-sums-are-open", "no-fit-without-a-turn"},
    .cases = 40,
    .check = check,
});

}  // namespace

}  // namespace oplus
