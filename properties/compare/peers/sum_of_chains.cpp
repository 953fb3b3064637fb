// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/sum_of_chains.hpp"

#include <algorithm>
#include <iterator>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/ray.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string text(const Segment& s) { return to_string(s.source) + " to " + to_string(s.target); }

/// The defect tells kinds apart.
[[noreturn]] void refuse(const std::string& defect, const std::string& where = "") {
  throw EngineFailure(EngineFailure::Kind::unreadable, defect, defect + where);
}

void check_lengths(const ReturnedChains& chains) {
  for (const Chain& chain : chains) {
    if (chain.size() < 3) refuse("a chain of " + counted(chain.size(), "vertex", "vertices"));
    for (const Segment& edge : edges(chain))
      if (edge.source == edge.target)
        refuse("an edge of length zero", " at " + to_string(edge.source));
  }
}

void check_pair(const Segment& a, const Segment& b) {
  const auto refuse_both = [&](const std::string& defect) {
    refuse(defect, ": " + text(a) + " and " + text(b));
  };
  if (cross_properly(a, b)) refuse_both("edges cross");
  if (!overlap(a, b)) return;
  refuse_both(sign(dot(direction_of(a), direction_of(b))) < 0 ? "an edge goes back along another"
                                                              : "edges overlap");
}

void check_sides(const std::vector<Segment>& pieces) {
  for (const Segment& piece : pieces) {
    const Vector d = direction_of(piece);
    // Nothing else meets the middle, as the pieces have no point but ends in common.
    const Point middle = midpoint(piece.source, piece.target);
    const int left = winding_number(point_beside(middle, {-d.y, d.x}, pieces), pieces);
    if (left == 1) continue;  // and 0 to the right, as no other piece runs along it
    refuse("winding number " + std::to_string(left) + " to the left of an edge",
           ", not 1: " + text(piece));
  }
}

}  // namespace

PlanarSet sum_of_chains(const ReturnedChains& chains) {
  check_lengths(chains);
  std::vector<Segment> all;
  for (const Chain& chain : chains) std::ranges::copy(edges(chain), std::back_inserter(all));
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) check_pair(all[i], all[j]);
  BoundaryFeatures features;
  for (const std::vector<Segment>& pieces : cut_at_intersections(all))
    std::ranges::copy(pieces, std::back_inserter(features.edges));
  check_sides(features.edges);
  return canonical_sum(features);
}

}  // namespace oplus
