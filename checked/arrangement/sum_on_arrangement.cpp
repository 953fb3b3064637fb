// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_on_arrangement.hpp"

#include <memory>
#include <utility>

#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/sum_boundary.hpp"
#include "checked/timed.hpp"

namespace oplus {

ComputedSum sum_on_arrangement(const Region& p, const Region& q, Boundary boundary,
                               const EngineOptions& options, const ArrangementMethod& method) {
  Seconds cycles{}, arranging{}, preparing{}, testing_holes{}, testing_points{}, output{};
  std::size_t hole_tests = 0;
  std::size_t point_tests = 0;

  std::unique_ptr<HoleTest> hole_test;
  const auto prepare = [&] {
    hole_test = options.hole_test ? options.hole_test(p, q) : hierarchy_hole_test(p, q);
  };
  if (method.has_hole_test) timed(preparing, prepare);

  std::vector<ConvolutionSegment> segments =
      timed(cycles, [&] { return method.convolution(p, q); });
  const std::size_t segment_count = segments.size();
  const ConvolutionArrangement arrangement =
      timed(arranging, [&] { return ConvolutionArrangement(std::move(segments)); });

  SumBoundary found;
  found.edges = timed(testing_holes, [&] {
    return method.boundary(arrangement, [&](ConvolutionArrangement::Halfedge h) {
      ++hole_tests;
      return hole_test->is_hole_right_of(arrangement.geometry(h));
    });
  });
  if (boundary == Boundary::open) {
    timed(testing_points, [&] {
      const auto interiors_meet_at = [&](const Point& x) {
        ++point_tests;
        if (!hole_test) prepare();
        return hole_test->interiors_meet_at(x);
      };
      add_low_dimensional_features(arrangement, p, q, interiors_meet_at, found);
    });
  }
  ComputedSum result;
  timed(output, [&] {
    result.sum = sum_within(arrangement, found);
    if (options.with_origins) result.origins = origins_of(result.sum, arrangement, found);
  });
  result.statistics = {{"segments in the arrangement", segment_count},
                       {"arrangement edges", std::size_t{arrangement.edge_count()}},
                       {"arrangement vertices", std::size_t{arrangement.vertex_count()}},
                       {"arrangement faces", std::size_t{arrangement.face_count()}},
                       {"hole tests", hole_tests},
                       {"tests of low-dimensional features", point_tests},
                       {"seconds for cycles", cycles},
                       {"seconds for the arrangement", arranging},
                       {"seconds to prepare hole tests", preparing},
                       {"seconds for hole tests", testing_holes},
                       {"seconds for low-dimensional features", testing_points},
                       {"seconds for the canonical form", output}};
  return result;
}

}  // namespace oplus
