// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "properties/runner/registry.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Fails where a point is entered more or less often than it is left.
void expect_cycles(const std::vector<ConvolutionSegment>& convolution, Outcome& outcome) {
  std::map<Point, int> surplus;
  for (const ConvolutionSegment& s : convolution) {
    ++surplus[s.segment.source];
    --surplus[s.segment.target];
  }
  outcome.counts["segments"] += convolution.size();
  outcome.counts["points"] += surplus.size();
  for (const auto& [point, leaving_less_entering] : surplus) {
    if (leaving_less_entering == 0) continue;
    outcome.fail(to_string(point) + " is left " + std::to_string(leaving_less_entering) +
                     " times more often than it is entered",
                 point);
    return;
  }
}

Outcome check(const Summands& summands) {
  const auto& [p, q] = summands;
  Outcome outcome;
  for (const ReflexVertex& vertex : reflex_vertices(p, q)) {
    ++outcome.counts["reflex vertices"];
    expect_cycles(replaced_at(vertex, p, q), outcome);
    if (outcome.kind == Outcome::Kind::fails) return outcome;
  }
  expect_cycles(original_convolution(p, q), outcome);
  return outcome;
}

const Registered registered(larger_mixture(),
                            {.id = "lemma-4.2.13",
                             .kills = {"flip-set-keeps-its-direction", "tangent-set-without-ties",
                                       "tie-rule-depends-on-who-asks"},
                             .cases = 1500,
                             .check = check});

}  // namespace

}  // namespace oplus
