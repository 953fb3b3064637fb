// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/nesting.hpp"
#include "checked/cli/layer_styles.hpp"
#include "checked/cli/view.hpp"
#include "checked/cycles/convolution_cycles.hpp"

namespace oplus {

namespace {

using Halfedge = ConvolutionArrangement::Halfedge;

/// The edges that no loop passes, in the directions of their segments.
Layer edges_on_no_loop(const ConvolutionArrangement& arrangement,
                       const std::vector<OrientableLoop>& loops) {
  std::vector<bool> is_on_loop(2 * arrangement.edge_count(), false);
  for (const OrientableLoop& loop : loops)
    for (const Halfedge h : loop) is_on_loop[h] = true;
  Layer layer{style::directed_lines("on-no-loop", "on no loop", 14, "#9a9a9a", 0.8)};
  for (Halfedge h = 0; h < is_on_loop.size(); ++h) {
    if (!is_on_loop[h] && !arrangement.along(h).empty())
      layer.segments.push_back(arrangement.geometry(h));
  }
  return layer;
}

}  // namespace

std::string loops_view(const Region& p, const Region& q) {
  const ConvolutionArrangement arrangement(traced_reduced_convolution(p, q));
  const std::vector<OrientableLoop> loops = orientable_loops(arrangement);
  const std::unique_ptr<HoleTest> test = hierarchy_hole_test(p, q);
  const std::vector<LoopVerdict> verdicts = judge(arrangement, loops, [&](Halfedge h) {
    return test->is_hole_right_of(arrangement.geometry(h));
  });

  Layer boundary{style::boundary_loop};
  Layer not_nested{style::directed_lines("not-nested-loop", "loop that is not nested", 16,
                                         "#d58a00", 2.2, "6 3")};
  Layer not_boundary{style::directed_lines("not-boundary-loop", "loop not of the boundary", 17,
                                           "#c0267e", 2.2, "2 3")};
  std::size_t of_boundary = 0, of_not_nested = 0, of_not_boundary = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const bool is_boundary = verdicts[i] == LoopVerdict::boundary;
    const bool is_nested = verdicts[i] != LoopVerdict::not_nested;
    ++(is_boundary ? of_boundary : is_nested ? of_not_boundary : of_not_nested);
    Layer& layer = is_boundary ? boundary : is_nested ? not_boundary : not_nested;
    for (const Halfedge h : loops[i]) layer.segments.push_back(arrangement.geometry(h));
  }
  return beside_summands(
      p, q,
      "Orientable loops: " + std::to_string(of_boundary) + " of the boundary, " +
          std::to_string(of_not_nested) + " not nested, " + std::to_string(of_not_boundary) +
          " not of the boundary",
      {edges_on_no_loop(arrangement, loops), not_boundary, not_nested, boundary});
}

}  // namespace oplus
