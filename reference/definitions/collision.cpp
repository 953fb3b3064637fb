// SPDX-License-Identifier: MIT
#include "reference/definitions/collision.hpp"

#include <algorithm>
#include <utility>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

/// The edges of a region, cut where its chains touch.
std::vector<Segment> boundary_pieces(const std::vector<Segment>& edges) {
  if (OPLUS_MUTANT("edges-are-not-cut-where-chains-touch")) return edges;
  std::vector<Segment> pieces;
  for (const Segment& edge : edges)
    for (Segment& piece : cut_where_met(edge, edges)) pieces.push_back(std::move(piece));
  return pieces;
}

/// Whether a piece of an edge of a, between two contacts with b's boundary, shows common interior:
/// the piece is inside b, or it runs along an edge of b in the same direction, so that both
/// interiors are to its left.
bool shows_common_interior(const Segment& piece, const Region& b,
                           const std::vector<Segment>& edges_of_b) {
  const Point middle = midpoint(piece.source, piece.target);
  switch (locate(middle, b)) {
    case Location::outside:
      return false;
    case Location::inside:
      return !OPLUS_MUTANT(
          "containment-is-no-collision",
          "a piece of one boundary inside the other region shows no common interior");
    case Location::boundary:
      if (OPLUS_MUTANT("parallel-edges-do-not-collide",
                       "interiors that meet along edges of equal direction only are missed"))
        return false;
      return std::any_of(edges_of_b.begin(), edges_of_b.end(), [&](const Segment& e) {
        return lies_on(middle, e) && sign(dot(direction_of(e), direction_of(piece))) > 0;
      });
  }
  return false;
}

/// Whether a piece of a's boundary shows common interior. Where no piece of either boundary does,
/// each component of one interior is outside the other region.
bool boundary_enters(const std::vector<Segment>& edges_of_a, const Region& b,
                     const std::vector<Segment>& edges_of_b) {
  for (const Segment& edge : edges_of_a) {
    for (const Segment& piece : cut_where_met(edge, edges_of_b)) {
      if (shows_common_interior(piece, b, edges_of_b)) return true;
    }
  }
  return false;
}

}  // namespace

bool interiors_meet(const Region& a, const Region& b) {
  // Cut where chains touch: only inside such pieces does a crossing show common interior.
  const std::vector<Segment> edges_of_a = boundary_pieces(edges(a));
  const std::vector<Segment> edges_of_b = boundary_pieces(edges(b));
  for (const Segment& s : edges_of_a) {
    for (const Segment& t : edges_of_b) {
      if (cross_properly(s, t)) return true;
    }
  }
  return boundary_enters(edges_of_a, b, edges_of_b) || boundary_enters(edges_of_b, a, edges_of_a);
}

}  // namespace oplus
