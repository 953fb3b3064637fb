// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_by_loops.hpp"

#include "checked/arrangement/nesting.hpp"
#include "checked/arrangement/sum_on_arrangement.hpp"
#include "checked/cycles/convolution_cycles.hpp"

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
                         const EngineOptions& options) {
  return sum_on_arrangement(p, q, boundary, options,
                            {.convolution = traced_reduced_convolution,
                             .boundary = boundary_of_loops,
                             .has_hole_test = true});
}

}  // namespace oplus
