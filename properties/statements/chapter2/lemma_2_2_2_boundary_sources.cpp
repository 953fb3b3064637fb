// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter2/paths_across.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Whether a is in the interior of one region and in the other region, boundary included.
bool is_interior_source(const OverlaidPoint& a) {
  return (a.is_in(0, true) && a.is_in(1, false)) || (a.is_in(1, true) && a.is_in(0, false));
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  const Region reflected_q = reflected(summands.q);
  bool meets_the_sum = false;
  for (const std::vector<Segment>& path : paths_across(summands)) {
    // In turn, a point where a path meets the vertex-edge sum, and one where it does not.
    const Segment& piece = path[path.size() / 2];
    meets_the_sum = !meets_the_sum;
    const Point x = meets_the_sum ? piece.source : midpoint(piece.source, piece.target);
    const bool is_in_sum = open_sum.contains(x);
    ++outcome.counts[is_in_sum ? "points of the open sum" : "other points"];
    for (const OverlaidPoint& a : overlaid({summands.p, translated(reflected_q, x)})) {
      if (a.in[0] == Location::boundary && a.in[1] == Location::boundary)
        ++outcome.counts["sources on both boundaries"];
      if (is_in_sum || !is_interior_source(a)) continue;
      return outcome.fail("the collision test says that " + to_string(x) +
                              " is not in the open sum, but it is the sum of " +
                              to_string(a.point) + " of P and " + to_string(x - a.point) +
                              " of Q, one of them an interior point",
                          x);
    }
  }
  return outcome;
}

const Registered registered(small_mixture(), {.id = "lemma-2.2.2",
                                              .kills = {"containment-is-no-collision"},
                                              .cases = 200,
                                              .check = check});

}  // namespace

}  // namespace oplus
