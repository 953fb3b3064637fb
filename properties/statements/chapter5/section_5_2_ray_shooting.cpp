// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/ray_shooting.hpp"
#include "checked/arrangement/winding_numbers.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Tests every edge of the arrangement of the full convolution, in both directions. That includes
/// horizontal and vertical edges, and rays through vertices and along overlaps.
Outcome check(const Summands& summands) {
  Outcome outcome;
  const std::vector<ConvolutionSegment> full =
      full_convolution(convolution_cycles(summands.p, summands.q));
  const RayShooting rays(segments(full));
  const ConvolutionArrangement arrangement(full);
  const std::vector<int> of_faces = winding_numbers(arrangement);
  for (ConvolutionArrangement::Halfedge h = 0; h < 2 * arrangement.edge_count(); ++h) {
    const Segment edge = arrangement.geometry(h);
    const int by_ray = rays.winding_number_right_of(edge);
    const int by_faces = of_faces[arrangement.face(ConvolutionArrangement::twin(h))];
    ++outcome.counts[by_ray == 0 ? "faces outside the sum" : "faces inside the sum"];
    if (by_ray == by_faces) continue;
    return outcome.fail("right of " + to_string(edge.source) + " to " + to_string(edge.target) +
                            " the ray counts " + std::to_string(by_ray) + ", the faces " +
                            std::to_string(by_faces),
                        midpoint(edge.source, edge.target));
  }
  return outcome;
}

const Registered registered(larger_mixture(),
                            {.id = "section-5.2",
                             .kills = {"overlapping-segments-count-once", "rays-shift-down",
                                       "rays-start-left-of-their-edge"},
                             .cases = 600,
                             .check = check});

}  // namespace

}  // namespace oplus
