// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_by_loops.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/covered_sum.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/writing.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  Outcome outcome;
  const PlanarSet sum = oracle_sum(summands.p, summands.q, Boundary::closed);
  const std::vector<ConvolutionSegment> reduced = reduced_convolution(summands.p, summands.q);
  for (const Segment& edge : edges(sum)) {
    ++outcome.counts["edges of the boundary"];
    std::vector<Segment> along;
    for (const ConvolutionSegment& s : reduced) {
      if (!overlap(s.segment, edge)) continue;
      if (same_direction(direction_of(s.segment), direction_of(edge))) {
        along.push_back(s.segment);
        continue;
      }
      outcome.fail("a segment runs against the edge from " + to_string(edge.source) + " to " +
                       to_string(edge.target),
                   midpoint(edge.source, edge.target));
    }
    if (cover(along, edge)) continue;
    outcome.fail("no segments run along all of the edge from " + to_string(edge.source) + " to " +
                     to_string(edge.target),
                 midpoint(edge.source, edge.target));
  }
  if (const auto found =
          difference(sum_by_loops(summands.p, summands.q, Boundary::closed).sum, sum))
    outcome.fail("the sum by loops is not the oracle's: " + found->what, found->witness);
  return outcome;
}

const Registered registered(small_mixture(), {.id = "lemma-3.1.2",
                                              .kills = {"loops-turn-counterclockwise-most"},
                                              .cases = 80,
                                              .check = check});

}  // namespace

}  // namespace oplus
