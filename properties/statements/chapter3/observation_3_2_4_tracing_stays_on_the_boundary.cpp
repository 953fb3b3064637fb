// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "checked/arrangement/orientable_loops.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

using Arrangement = ConvolutionArrangement;

/// Where all segments have one direction, the sum is to their left; so such an edge is on the
/// boundary of the closed sum iff the points inside it are not in the open sum.
Outcome check(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  const Arrangement arrangement(reduced_convolution(summands.p, summands.q));
  const auto is_boundary = [&](Arrangement::Halfedge h) {
    const Segment edge = arrangement.geometry(h);
    return !open_sum.contains(midpoint(edge.source, edge.target));
  };
  const auto fail = [&](Arrangement::Halfedge h, const std::string& what) {
    const Segment edge = arrangement.geometry(h);
    outcome.fail("from " + to_string(edge.source) + " to " + to_string(edge.target) + " " + what,
                 midpoint(edge.source, edge.target));
  };
  std::set<Arrangement::Halfedge> on_loops;
  for (const OrientableLoop& loop : orientable_loops(arrangement)) {
    const bool first = is_boundary(loop[0]);
    ++outcome.counts[first ? "loops on the boundary" : "other loops"];
    for (const Arrangement::Halfedge h : loop) {
      on_loops.insert(h);
      if (is_boundary(h) != first) fail(h, "a loop leaves or enters the boundary");
    }
  }
  for (Arrangement::Halfedge h = 0; h < 2 * arrangement.edge_count(); ++h) {
    const bool one_way =
        !arrangement.along(h).empty() && arrangement.along(Arrangement::twin(h)).empty();
    if (one_way && on_loops.count(h) == 0 && is_boundary(h)) fail(h, "the boundary is on no loop");
  }
  return outcome;
}

const Registered registered(small_mixture(), {.id = "observation-3.2.4",
                                              .kills = {"loops-turn-counterclockwise-most"},
                                              .cases = 400,
                                              .check = check});

}  // namespace

}  // namespace oplus
