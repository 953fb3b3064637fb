// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/orientable_loops.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  const ConvolutionArrangement arrangement(reduced_convolution(summands.p, summands.q));
  const std::vector<OrientableLoop> loops = orientable_loops(arrangement);
  for (const auto& [name, method] : hole_test_methods()) {
    const auto test = method(summands.p, summands.q);
    for (const OrientableLoop& loop : loops) {
      const bool of_loop = test->is_hole_right_of(arrangement.geometry(loop[0]));
      outcome.counts[of_loop ? "edges of loops on the boundary" : "edges of other loops"] +=
          loop.size();
      for (const ConvolutionArrangement::Halfedge h : loop) {
        const Segment edge = arrangement.geometry(h);
        const Point middle = midpoint(edge.source, edge.target);
        const bool collides = open_sum.contains(middle);
        if (collides != of_loop && test->is_hole_right_of(edge) == of_loop) continue;
        return outcome.fail("hole test " + name + " and the definition differ on the edge from " +
                                to_string(edge.source) + " to " + to_string(edge.target) +
                                " of a loop",
                            middle);
      }
    }
  }
  return outcome;
}

const Registered registered(small_mixture(), {.id = "observation-3.1.5",
                                              .kills = {"rays-start-left-of-their-edge"},
                                              .cases = 300,
                                              .check = check});

}  // namespace

}  // namespace oplus
