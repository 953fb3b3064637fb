// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/distance/distance.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/operations/places_of_q.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Of the origin from a closed set.
Rational squared_distance(const PlanarSet& set) {
  if (locate({}, set) != Location::outside) return 0;
  const std::vector<Segment> boundary = edges(set);
  Rational least = squared_distance({}, boundary.at(0));
  for (const Segment& edge : boundary) least = std::min(least, squared_distance({}, edge));
  return least;
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  for (std::size_t kind = 0; kind < fitting_kinds; ++kind) {
    const auto [how, pair] = fitting_pair(summands, kind);
    for (const Region& q : places_of_q(pair, 4)) {
      const auto [squared, on_p, on_q] = distance(pair.p, q);
      const PlanarSet sum = unbounded_sum(pair.p, reflected(q), Boundary::closed, by_slide);
      const Rational right = squared_distance(sum);
      ++outcome.counts[sgn(right) > 0                          ? "regions that are apart"
                       : locate({}, sum) == Location::boundary ? "regions that touch"
                                                               : "regions that overlap"];
      if (squared != right)
        return outcome.fail(how + ": the squared distance is " + to_string(right) + ", not " +
                            to_string(squared));
      if (squared_length(on_p - on_q) != squared)
        return outcome.fail(how + ": the points are not at the distance", on_p);
      if (locate(on_p, pair.p) == Location::outside || locate(on_q, q) == Location::outside)
        return outcome.fail(how + ": one of the points is not in its region", on_p);
    }
  }
  return outcome;
}

const Registered registered({
    .id = "law-distance",
    .sources = {{"tight", 2, 3}, {"grid", 5, 4}, {"holes", 4, 2}, {"components", 3, 3}},
    .promises = {{"holes", 10}, {"several components", 10}, {"parallel edges", 40}},
    .kills = {"distances-from-one-side", "distances-from-boundaries"},
    .cases = 50,
    .check = check,
});

}  // namespace

}  // namespace oplus
