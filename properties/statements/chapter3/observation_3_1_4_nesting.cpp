// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/nesting.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

using Arrangement = ConvolutionArrangement;

/// Compares the filters' verdict on each loop with the definition of the sum. If two boundary loops
/// of one kind were directly inside each other, the filters would discard one of them.
Outcome check(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  const Arrangement arrangement(reduced_convolution(summands.p, summands.q));
  const auto is_boundary = [&](Arrangement::Halfedge h) {
    const Segment edge = arrangement.geometry(h);
    return !open_sum.contains(midpoint(edge.source, edge.target));
  };
  const std::vector<OrientableLoop> loops = orientable_loops(arrangement);
  const std::vector<LoopVerdict> verdicts = judge(arrangement, loops, is_boundary);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const bool expected = is_boundary(loops[i][0]);
    outcome.counts["loops on the boundary"] += expected;
    outcome.counts["other loops"] += !expected;
    outcome.counts["loops that are not nested"] += verdicts[i] == LoopVerdict::not_nested;
    if ((verdicts[i] == LoopVerdict::boundary) == expected) continue;
    const Point at = arrangement.point(arrangement.source(loops[i][0]));
    outcome.fail("the loop through " + to_string(at) +
                     (expected ? " is on the boundary, and the filters discard it"
                               : " is not on the boundary, and the filters keep it"),
                 at);
  }
  return outcome;
}

const Registered registered({
    .id = "observation-3.1.4",
    .sources = {{"grid", 8, 4},
                {"tight", 4, 2},
                {"holes", 6, 3},
                {"components", 5, 2},
                {"islands", 3, 3},
                {"fork", 2, 1},
                {"comb", 3, 1}},
    .promises = usual_promises(),
    .kills = {"islands-are-not-nested", "nested-loops-need-no-hole-test"},
    .cases = 300,
    .check = check,
});

}  // namespace

}  // namespace oplus
