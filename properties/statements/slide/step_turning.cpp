// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/slide.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const PlanarSet sum = slide_sum(summands.p, summands.q, Boundary::closed).sum;
  Outcome outcome;
  for (const std::vector<Chain>* of_kind : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *of_kind) {
      const bool is_outer = of_kind == &sum.outer;
      ++outcome.counts[is_outer ? "outer chains" : "holes"];
      if ((sign(twice_area(chain)) > 0) == is_outer) continue;
      return outcome.fail(
          is_outer ? "an outer chain runs clockwise" : "a hole runs counterclockwise", chain[0]);
    }
  }
  return outcome;
}

const Registered registered({
    .id = "step-turning",
    .sources = {{"grid", 8, 2},
                {"tight", 6, 4},
                {"holes", 5, 3},
                {"components", 5, 2},
                {"islands", 2, 1},
                {"fork", 3, 2},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 15}},
    .kills = {"slide-sees-no-right-turn"},
    .cases = 1000,
    .check = check,
});

}  // namespace

}  // namespace oplus
