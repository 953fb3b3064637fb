// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_on_reduced_convolution.hpp"

#include <memory>

#include "checked/arrangement/sum_on_arrangement.hpp"
#include "checked/cycles/convolution_cycles.hpp"

namespace oplus {

ComputedSum sum_on_reduced_convolution(const Region& p, const Region& q, Boundary boundary,
                                       WithOrigins with_origins, HoleTest& hole_test,
                                       const FindBoundary& find_boundary) {
  const auto boundary_by_hole_tests = [&](const ConvolutionArrangement& arrangement,
                                          RunStatistics& statistics) {
    return find_boundary(arrangement, [&](ConvolutionArrangement::Halfedge h) {
      ++statistics.hole_tests;
      return hole_test.is_hole_right_of(arrangement.geometry(h));
    });
  };
  return sum_on_arrangement(
      p, q, boundary, with_origins,
      {[&] { return traced_reduced_convolution(p, q); }, boundary_by_hole_tests,
       [&](const Point& x) { return hole_test.interiors_meet_at(x); }});
}

ComputedSum with_hole_test(const Region& p, const Region& q, HoleTestMethod method,
                           const std::function<ComputedSum(HoleTest&)>& compute) {
  Stages::Duration preparing{};
  const std::unique_ptr<HoleTest> test = timed(preparing, [&] { return hole_test(method, p, q); });
  ComputedSum result = compute(*test);
  result.statistics.stages.hierarchy = preparing;
  return result;
}

}  // namespace oplus
