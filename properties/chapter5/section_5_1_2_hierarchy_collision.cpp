// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <set>

#include "checked/collision/hierarchy_collision.hpp"
#include "properties/chapter4/points_beside.hpp"
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Every kind of placement there is: one in each face of the convolution's arrangement, one inside
/// each piece of the vertex-edge sum, where a vertex is on an edge, and each end of a piece, where
/// vertices meet or several vertices are on edges.
std::set<Point> placements(const Summands& summands) {
  const std::vector<Point> beside = points_beside(segments(convolution(summands.p, summands.q)));
  std::set<Point> result(beside.begin(), beside.end());
  for (const auto& pieces :
       cut_at_intersections(segments(vertex_edge_sum(summands.p, summands.q)))) {
    for (const Segment& piece : pieces)
      result.insert({piece.source, piece.target, midpoint(piece.source, piece.target)});
  }
  return result;
}

Outcome check(const Summands& summands) {
  const std::unique_ptr<CollisionTest> by_hierarchy = hierarchy_collision(summands.p, summands.q);
  const Region reflected_q = reflected(summands.q);
  Outcome outcome;
  for (const Point& x : placements(summands)) {
    const bool meet = interiors_meet(summands.p, translated(reflected_q, x));
    ++outcome.counts[meet ? "placements that collide" : "placements that do not"];
    if (by_hierarchy->interiors_meet_at(x) == meet) continue;
    outcome.kind = Outcome::Kind::fails;
    outcome.why = "at " + to_string(x) + " the interiors of P and -Q+x " +
                  (meet ? "meet" : "do not meet") + ", the hierarchies say the opposite";
    break;
  }
  return outcome;
}

const Registered registered({
    .id = "section-5.1.2",
    .kind = "section",
    .title = "Hierarchies of bounding volumes decide collision",
    .statement = "Two hierarchies built once, that of -Q translated by x, give the same answer as "
                 "comparing all pairs of edges: whether the interiors of P and -Q+x meet.",
    .why =
        "Edges whose boxes are apart do not meet, so every crossing and every contact is visited. "
        "A proper crossing shows common interior. Around a contact the sectors between the edges "
        "that leave it tell whether both interiors are in one of them. Where neither happens, a "
        "chain without contact is inside or outside the other region as a whole.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {},
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"parallel-edges-do-not-collide", "weak-intersections-never-meet"},
    .cases = 300,
    .file = __FILE__,
    .check = check,
});

}  // namespace

}  // namespace oplus
