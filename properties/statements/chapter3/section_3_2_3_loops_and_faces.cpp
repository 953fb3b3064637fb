// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/nesting.hpp"
#include "checked/arrangement/rca.hpp"
#include "checked/arrangement/sum_by_loops.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "reference/definitions/difference.hpp"

namespace oplus {

namespace {

using Halfedge = ConvolutionArrangement::Halfedge;

/// Counts what the filters discard; a loop that the nesting filter discards must not be on the
/// boundary.
void look_at_loops(const Summands& summands, Outcome& outcome) {
  const ConvolutionArrangement arrangement(
      reduced_convolution(convolution_cycles(summands.p, summands.q)));
  const auto test = hierarchy_hole_test(summands.p, summands.q);
  const auto is_hole_right_of = [&](Halfedge h) {
    return test->is_hole_right_of(arrangement.geometry(h));
  };
  const std::vector<OrientableLoop> loops = orientable_loops(arrangement);
  const std::vector<LoopVerdict> verdicts = judge(arrangement, loops, is_hole_right_of);
  outcome.counts["orientable loops"] += loops.size();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    outcome.counts["loops on the boundary"] += verdicts[i] == LoopVerdict::boundary;
    outcome.counts["loops that a hole test discards"] += verdicts[i] == LoopVerdict::not_boundary;
    if (verdicts[i] != LoopVerdict::not_nested) continue;
    ++outcome.counts["loops that the nesting filter discards"];
    if (!is_hole_right_of(loops[i][0])) continue;
    outcome.fail("the nesting filter discards a loop on the boundary");
  }
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const auto found = difference(rca(summands.p, summands.q, boundary).sum,
                                  sum_by_loops(summands.p, summands.q, boundary).sum);
    if (found)
      return outcome.fail("faces give the first sum, loops the second: " + found->what,
                          found->witness);
  }
  look_at_loops(summands, outcome);
  return outcome;
}

const Registered registered({
    .id = "section-3.2.3",
    .sources = {{"grid", 8, 4},
                {"tight", 6, 2},
                {"holes", 6, 3},
                {"components", 5, 2},
                {"islands", 3, 2},
                {"fork", 4, 2},
                {"comb", 4, 1},
                {"star", 16, 1},
                {"simple", 12, 1}},
    .promises = usual_promises(),
    .kills = {"candidates-need-no-hole-test", "islands-are-not-nested",
              "loops-turn-counterclockwise-most"},
    .cases = 600,
    .check = check,
});

}  // namespace

}  // namespace oplus
