// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/verify/verify.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/claimed_sum.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  Outcome outcome;
  const auto& [p, q] = summands;
  const OracleSums sums = oracle_sums(p, q);
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const PlanarSet& sum = boundary == Boundary::open ? sums.open : sums.closed;
    const Verdict verdict = verify(p, q, boundary, sum);
    if (!verdict.is_sum())
      return outcome.fail("verify refuses the oracle's sum: " + verdict.reasons.front().detail,
                          verdict.reasons.front().witness);
    const auto accepts = [&](const ClaimedSum& given) {
      ++outcome.counts["wrong sums"];
      return verify(p, q, boundary, given).is_sum();
    };

    ClaimedSum turned = given(sum);
    for (Component& component : turned.region.components) {
      std::reverse(component.outer.begin(), component.outer.end());
      if (accepts(turned)) return outcome.fail("verify accepts a clockwise outer chain");
      std::reverse(component.outer.begin(), component.outer.end());
    }
    ClaimedSum with_a_point = given(sum);
    with_a_point.region.components.push_back({Chain(3, Point{}), {}});
    if (accepts(with_a_point)) return outcome.fail("verify accepts a chain that is a point");
    for (std::size_t i = 0; i < sum.holes.size(); ++i) {
      PlanarSet filled = sum;
      filled.holes.erase(filled.holes.begin() + static_cast<std::ptrdiff_t>(i));
      if (accepts(given(filled)))
        return outcome.fail("verify accepts a sum without one of its holes");
    }
  }
  if (sums.open != sums.closed) {
    ++outcome.counts["open sums with low-dimensional features"];
    ++outcome.counts["wrong sums"];
    if (verify(p, q, Boundary::open, sums.closed).is_sum() ||
        verify(p, q, Boundary::closed, sums.open).is_sum())
      return outcome.fail("verify accepts the sum of the other kind of boundary");
  }
  return outcome;
}

const Registered registered(
    tight_mixture(),
    {
        .id = "fact-verify",
        .kills = {"chains-may-run-either-way", "edges-of-convex-sums-count-on-neither-side",
                  "points-between-convex-sums-are-inside", "points-need-not-bound",
                  "sides-of-convex-sums-start-anywhere", "triangles-end-where-edges-do",
                  "verify-sees-no-dangling-edges"},
        .cases = 100,
        .check = check,
    });

}  // namespace

}  // namespace oplus
