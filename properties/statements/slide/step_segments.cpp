// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/slide/slid_pair.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  std::vector<Origin> found, defined;
  for (std::uint32_t i = 0; i < pair.segments.size(); ++i) found.push_back(pair.segments.origin(i));
  for (const ConvolutionSegment& s : reduced_convolution(summands.p, summands.q))
    defined.push_back(s.origin);
  std::sort(found.begin(), found.end());
  std::sort(defined.begin(), defined.end());
  Outcome outcome;
  outcome.counts["segments"] = found.size();
  if (found != defined) {
    outcome.fail(counted(found.size(), "segment", "segments") + " by ranks, " +
                 std::to_string(defined.size()) + " by the definition");
  }
  return outcome;
}

const Registered registered(small_mixture(), {.id = "step-segments",
                                              .kills = {"slide-ranks-without-ties"},
                                              .cases = 600,
                                              .check = check});

}  // namespace

}  // namespace oplus
