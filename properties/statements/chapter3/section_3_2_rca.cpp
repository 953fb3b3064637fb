// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/judge.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const JudgedPair result = judged({"", summands}, {.engines = checked_engines()});
  Outcome outcome;
  if (result.right) {
    const PlanarSet& open = result.right->open;
    outcome.counts["sums with holes"] = !result.right->closed.holes.empty();
    outcome.counts["open sums with low-dimensional features"] =
        !open.dangling_edges.empty() || !open.isolated_vertices.empty();
  }
  for (const JudgedSum& sum : result.sums) {
    if (!sum.wrong) continue;
    return outcome.fail(sum.engine + ": " + sum.wrong->failure.what, sum.wrong->failure.witness);
  }
  return outcome;
}

const Registered registered({
    .id = "section-3.2",
    .sources = {{"grid", 8, 4},
                {"tight", 6, 3},
                {"holes", 5, 2},
                {"components", 5, 2},
                {"islands", 2, 2},
                {"fork", 3, 1},
                {"diamond-u", 1, 1},
                {"simple", 8, 1}},
    .promises = usual_promises(),
    .kills = {"candidates-need-no-hole-test", "slide-turns-counterclockwise-most",
              "touching-points-are-not-tested", "weak-intersections-never-meet"},
    .cases = 100,
    .check = check,
});

}  // namespace

}  // namespace oplus
