// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_by_winding_numbers.hpp"

#include "checked/arrangement/sum_on_arrangement.hpp"
#include "checked/arrangement/winding_numbers.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "reference/definitions/contract.hpp"

namespace oplus {

namespace {

using Halfedge = ConvolutionArrangement::Halfedge;

std::vector<Halfedge> boundary_of_positive_faces(const ConvolutionArrangement& arrangement,
                                                 const IsHoleRightOf& /*not asked*/) {
  const std::vector<int> numbers = winding_numbers(arrangement);
  std::vector<Halfedge> boundary;
  for (Halfedge h = 0; h < 2 * arrangement.edge_count(); ++h) {
    const int left = numbers[arrangement.face(h)];
    OPLUS_ENSURES(left >= 0, "Theorem 4.2.1");
    if (left > 0 && numbers[arrangement.face(ConvolutionArrangement::twin(h))] <= 0)
      boundary.push_back(h);
  }
  return boundary;
}

}  // namespace

ComputedSum sum_by_winding_numbers(const Region& p, const Region& q, Boundary boundary,
                                   const EngineOptions& options) {
  return sum_on_arrangement(p, q, boundary, options,
                            {.convolution = traced_convolution,
                             .boundary = boundary_of_positive_faces,
                             .has_hole_test = false});
}

}  // namespace oplus
