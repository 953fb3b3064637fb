// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

bool equal(const ConvolutionSegment& a, const ConvolutionSegment& b) {
  return a.origin == b.origin && a.segment == b.segment && a.vertex_is_reflex == b.vertex_is_reflex;
}

bool equal_as_multisets(std::vector<ConvolutionSegment> a, std::vector<ConvolutionSegment> b) {
  // Origins are distinct, so this order is the only one.
  for (std::vector<ConvolutionSegment>* segments : {&a, &b})
    std::ranges::sort(*segments, {}, &ConvolutionSegment::origin);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

bool are_origins_of(const std::vector<ConvolutionSegment>& segments,
                    const std::vector<TracedOrigin>& origins) {
  return std::equal(segments.begin(), segments.end(), origins.begin(), origins.end(),
                    [](const ConvolutionSegment& s, const TracedOrigin& o) {
                      return s.origin == o.origin && s.vertex_is_reflex == o.vertex_is_reflex;
                    });
}

Outcome check(const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<ConvolutionSegment> full = convolution(p, q);
  const std::vector<ConvolutionSegment> reduced = reduced_convolution(p, q);
  const ConvolutionCycles cycles = convolution_cycles(p, q);
  const std::vector<ConvolutionSegment> traced = traced_convolution(p, q);
  Outcome outcome;
  outcome.counts = {{"segments of the full convolution", full.size()},
                    {"segments of the reduced convolution", reduced.size()}};
  if (!equal_as_multisets(full_convolution(cycles), full))
    outcome.why = "the cycles' segments are not the convolution";
  else if (!equal_as_multisets(reduced_convolution(cycles), reduced))
    outcome.why = "the cycles' segments without reflex vertices are not the reduced convolution";
  else if (!equal_as_multisets(traced, full))
    outcome.why = "the segments traced one by one are not the convolution";
  else if (!equal_as_multisets(traced_reduced_convolution(p, q), reduced))
    outcome.why =
        "the segments traced one by one, without reflex vertices, are not the reduced "
        "convolution";
  else if (!are_origins_of(traced, traced_origins(p, q)))
    outcome.why = "tracing without points gives other segments";
  if (!outcome.why.empty()) outcome.kind = Outcome::Kind::fails;
  return outcome;
}

const Registered registered(
    larger_mixture(), {
                          .id = "section-3.2.1",
                          .kills = {"filtered-ties-the-other-way", "no-start-in-the-first-column",
                                    "reflex-where-angles-decrease", "tie-rule-depends-on-who-asks",
                                    "tangent-set-without-ties", "reflex-turns-clockwise"},
                          .cases = 1500,
                          .check = check,
                      });

}  // namespace

}  // namespace oplus
