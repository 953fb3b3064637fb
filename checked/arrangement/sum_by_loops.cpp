// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_by_loops.hpp"

#include "checked/arrangement/nesting.hpp"
#include "checked/arrangement/sum_on_reduced_convolution.hpp"

namespace oplus {

namespace {

std::vector<ConvolutionArrangement::Halfedge> boundary_of_loops(
    const ConvolutionArrangement& arrangement, const IsHoleRightOf& is_hole_right_of) {
  const std::vector<OrientableLoop> loops = orientable_loops(arrangement);
  const std::vector<LoopVerdict> verdicts = judge(arrangement, loops, is_hole_right_of);
  std::vector<ConvolutionArrangement::Halfedge> boundary;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (verdicts[i] == LoopVerdict::boundary)
      boundary.insert(boundary.end(), loops[i].begin(), loops[i].end());
  }
  return boundary;
}

}  // namespace

ComputedSum sum_by_loops(const Region& p, const Region& q, Boundary boundary,
                         WithOrigins with_origins, HoleTest& hole_test) {
  return sum_on_reduced_convolution(p, q, boundary, with_origins, hole_test, boundary_of_loops);
}

ComputedSum sum_by_loops(const Region& p, const Region& q, Boundary boundary,
                         WithOrigins with_origins, HoleTestMethod method) {
  return with_hole_test(p, q, method, [&](HoleTest& test) {
    return sum_by_loops(p, q, boundary, with_origins, test);
  });
}

}  // namespace oplus
