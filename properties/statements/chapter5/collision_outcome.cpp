// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter5/collision_outcome.hpp"

#include <ranges>
#include <set>

#include "properties/statements/chapter5/boundary_contact.hpp"
#include "properties/statements/placements/points_beside.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Placements of -Q of every kind: one in each face of the convolution's arrangement; one inside
/// each piece of the vertex-edge sum, where a vertex is on an edge; and each end of a piece, where
/// vertices meet or several vertices are on edges.
std::set<Point> placements(const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<Point> beside = points_beside(segments(convolution(p, q)));
  std::set<Point> result(beside.begin(), beside.end());
  for (const Segment& piece :
       cut_at_intersections(segments(vertex_edge_sum(p, q))) | std::views::join)
    result.insert({piece.source, piece.target, midpoint(piece.source, piece.target)});
  return result;
}

}  // namespace

Outcome collision_outcome(CollisionTest& method, const Summands& summands) {
  const Region minus_q = reflected(summands.q);
  Outcome outcome;
  for (const Point& x : placements(summands)) {
    const Region placed = translated(minus_q, x);
    const bool meet = interiors_meet(summands.p, placed);
    const std::string contact = describe(strongest_contact(summands.p, placed));
    ++outcome.counts["placements " + contact + (meet ? " that collide" : " that do not")];
    if (method.interiors_meet_at(x) == meet) continue;
    outcome.fail("at " + to_string(x) + ", " + contact + ", the interiors of P and -Q+x " +
                     (meet ? "meet" : "do not meet") + ", and the method says the opposite",
                 x);
    break;
  }
  return outcome;
}

}  // namespace oplus
