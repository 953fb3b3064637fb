// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <ranges>
#include <set>

#include "checked/sweep/sweep_collision.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter5/boundary_contact.hpp"
#include "properties/statements/placements/overlay.hpp"
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

/// A way to build a method of collision tests for a pair.
using MethodFor = std::unique_ptr<CollisionTest> (*)(const Region& p, const Region& q);

/// Whether a method answers as the definition (`interiors_meet`) does at every kind of placement there
/// is. Counts them by their strongest contact and by the answer.
Outcome check(MethodFor method_for, const Summands& summands) {
  const std::unique_ptr<CollisionTest> method = method_for(summands.p, summands.q);
  const Region minus_q = reflected(summands.q);
  Outcome outcome;
  for (const Point& x : placements(summands)) {
    const Region placed = translated(minus_q, x);
    const bool meet = interiors_meet(summands.p, placed);
    const std::string contact = describe(strongest_contact(summands.p, placed));
    ++outcome.counts["placements " + contact + (meet ? " that collide" : " that do not")];
    if (method->interiors_meet_at(x) == meet) continue;
    outcome.fail("at " + to_string(x) + ", " + contact + ", the interiors of P and -Q+x " +
                     (meet ? "meet" : "do not meet") + ", and the method says the opposite",
                 x);
    break;
  }
  return outcome;
}

Registered collision(MethodFor method_for, Statement statement) {
  statement.cases = 60;
  statement.check = [=](const Summands& summands) { return check(method_for, summands); };
  return Registered(small_mixture(), std::move(statement));
}

const Registered registered[] = {
    collision(naive_collision, {.id = "section-5.1", .kills = {"weak-intersections-never-meet"}}),
    collision(sweep_collision,
              {.id = "section-5.1.1",
               .kills = {"sweep-forgets-overlap-direction", "sweep-ignores-weak-intersections"}}),
    collision(hierarchy_collision,
              {.id = "section-5.1.2",
               .kills = {"parallel-edges-do-not-collide", "weak-intersections-never-meet"}})};

}  // namespace

}  // namespace oplus
