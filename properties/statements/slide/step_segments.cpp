// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/slide/slid_pair.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  std::vector<Origin> found, defined;
  for (std::uint32_t i = 0; i < pair.tracks.size(); ++i) found.push_back(pair.tracks.origin(i));
  for (const ConvolutionSegment& s : reduced_convolution(summands.p, summands.q))
    defined.push_back(s.origin);
  std::sort(found.begin(), found.end());
  std::sort(defined.begin(), defined.end());
  Outcome outcome;
  outcome.counts["segments"] = found.size();
  if (found != defined) {
    outcome.fail(std::to_string(found.size()) + " segments by ranks, " +
                 std::to_string(defined.size()) + " by the definition");
  }
  return outcome;
}

const Registered registered({
    .id = "step-segments",
    .title = "The segments are those of the reduced convolution",
    .statement = "slide finds exactly the segments of the reduced convolution, each once: ranks of "
                 "directions give the same segments as comparing all pairs by the definition.",
    .why =
        "A direction is in the tangent set of a convex vertex iff, turning counterclockwise, it "
        "is met after the edge that enters and before the edge that leaves. With all directions "
        "of both summands sorted once, ties by the one rule of Definition 2.2.7, these directions "
        "are a range of ranks, which may continue from the last rank to the first. At a reflex "
        "vertex and inside a straight line there is no such segment.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {"definition-2.2.7", "theorem-2.3.2"},
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"slide-ranks-without-ties"},
    .cases = 600,
    .check = check,
});

}  // namespace

}  // namespace oplus
