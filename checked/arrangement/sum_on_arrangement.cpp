// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_on_arrangement.hpp"

#include <utility>

#include "checked/arrangement/sum_boundary.hpp"

namespace oplus {

ComputedSum sum_on_arrangement(const Region& p, const Region& q, Boundary boundary,
                               WithOrigins with_origins, const ArrangementMethod& method) {
  ComputedSum result;
  RunStatistics& statistics = result.statistics;
  Stages& stages = statistics.stages;

  std::vector<ConvolutionSegment> segments = timed(stages.cycles, method.convolution);
  statistics.segments = segments.size();
  const ConvolutionArrangement arrangement =
      timed(stages.arrangement, [&] { return ConvolutionArrangement(std::move(segments)); });
  statistics.arrangement_vertices = arrangement.vertex_count();
  statistics.arrangement_edges = arrangement.edge_count();
  statistics.arrangement_faces = arrangement.face_count();

  SumBoundary found;
  found.edges = timed(stages.hole_test, [&] { return method.boundary(arrangement, statistics); });
  if (boundary == Boundary::open) {
    timed(stages.degenerate, [&] {
      const auto counted = [&](const Point& x) {
        ++statistics.point_tests;
        return method.interiors_meet_at(x);
      };
      add_low_dimensional_features(arrangement, p, q, counted, found);
    });
  }
  timed(stages.output, [&] {
    result.sum = sum_within(arrangement, found);
    if (with_origins == WithOrigins::yes)
      result.origins = origins_of(result.sum, arrangement, found);
  });
  return result;
}

}  // namespace oplus
