// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/sum_of_chains.hpp"

#include <optional>
#include <utility>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string text(const Segment& s) { return to_string(s.source) + " to " + to_string(s.target); }

void check_lengths(const ReturnedChains& chains) {
  for (const Chain& chain : chains) {
    if (chain.size() < 3) {
      const std::string defect = "a chain of " + std::to_string(chain.size()) + " vertices";
      throw NoRegion(defect, defect);
    }
    for (const Segment& edge : edges(chain))
      if (edge.source == edge.target)
        throw NoRegion("an edge of length zero",
                       "an edge of length zero at " + to_string(edge.source));
  }
}

void check_pair(const Segment& a, const Segment& b) {
  const auto refuse = [&](const std::string& defect) {
    throw NoRegion(defect, defect + ": " + text(a) + " and " + text(b));
  };
  if (cross_properly(a, b)) refuse("edges cross");
  if (!overlap(a, b)) return;
  refuse(sign(dot(direction_of(a), direction_of(b))) < 0 ? "an edge goes back along another"
                                                         : "edges overlap");
}

/// The winding number just beside the middle of a piece, where `normal` points from it. Nothing else
/// meets the middle, as the pieces have no point but ends in common.
int winding_number_beside(const Segment& piece, const Vector& normal,
                          const std::vector<Segment>& pieces) {
  const Point middle = midpoint(piece.source, piece.target);
  // The ray meets a piece first at t, or ends of a piece in line with it.
  std::optional<Rational> first;
  const auto at = [&](const Rational& t) {
    if (sign(t) > 0 && (!first || t < *first)) first = t;
  };
  for (const Segment& e : pieces) {
    const Vector d = direction_of(e);
    const Rational turn = cross(normal, d);
    if (turn == 0) {
      for (const Point& end : {e.source, e.target})
        if (cross(normal, end - middle) == 0) at(dot(normal, end - middle) / dot(normal, normal));
      continue;
    }
    const Rational along = cross(e.source - middle, normal) / turn;
    if (sign(along) >= 0 && along <= 1) at(cross(e.source - middle, d) / turn);
  }
  return winding_number(middle + (first ? Rational(*first / 2) : Rational(1)) * normal, pieces);
}

void check_sides(const std::vector<Segment>& pieces) {
  for (const Segment& piece : pieces) {
    const Vector d = direction_of(piece);
    const int left = winding_number_beside(piece, {-d.y, d.x}, pieces);
    if (left == 1) continue;  // and 0 to the right, as no other piece runs along it
    const std::string defect = "winding number " + std::to_string(left) + " to the left of an edge";
    throw NoRegion(defect, defect + ", not 1: " + text(piece));
  }
}

}  // namespace

MinkowskiSum sum_of_chains(const ReturnedChains& chains) {
  check_lengths(chains);
  std::vector<Segment> all;
  for (const Chain& chain : chains) {
    const std::vector<Segment> of_chain = edges(chain);
    all.insert(all.end(), of_chain.begin(), of_chain.end());
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) check_pair(all[i], all[j]);
  BoundaryFeatures features;
  for (const std::vector<Segment>& pieces : cut_at_intersections(all))
    features.edges.insert(features.edges.end(), pieces.begin(), pieces.end());
  check_sides(features.edges);
  return canonical_sum(features);
}

}  // namespace oplus
