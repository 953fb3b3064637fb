// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_by_winding_numbers.hpp"

#include <functional>
#include <memory>

#include "checked/arrangement/sum_on_arrangement.hpp"
#include "checked/arrangement/winding_numbers.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "reference/definitions/contract.hpp"

namespace oplus {

namespace {

using Halfedge = ConvolutionArrangement::Halfedge;

std::vector<Halfedge> boundary_of_positive_faces(const ConvolutionArrangement& arrangement,
                                                 RunStatistics& /*counts no questions*/) {
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

ComputedSum sum_with(const Region& p, const Region& q, Boundary boundary, WithOrigins with_origins,
                     const std::function<bool(const Point&)>& interiors_meet_at) {
  return sum_on_arrangement(
      p, q, boundary, with_origins,
      {[&] { return traced_convolution(p, q); }, boundary_of_positive_faces, interiors_meet_at});
}

}  // namespace

ComputedSum sum_by_winding_numbers(const Region& p, const Region& q, Boundary boundary,
                                   WithOrigins with_origins, CollisionTest& collision) {
  return sum_with(p, q, boundary, with_origins,
                  [&](const Point& x) { return collision.interiors_meet_at(x); });
}

ComputedSum sum_by_winding_numbers(const Region& p, const Region& q, Boundary boundary,
                                   WithOrigins with_origins, CollisionMethod method) {
  std::unique_ptr<CollisionTest> collision;  // most sums need none
  return sum_with(p, q, boundary, with_origins, [&](const Point& x) {
    if (!collision) collision = collision_test(method, p, q);
    return collision->interiors_meet_at(x);
  });
}

}  // namespace oplus
