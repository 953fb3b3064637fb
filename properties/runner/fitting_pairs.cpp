// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/fitting_pairs.hpp"

#include <functional>
#include <vector>

#include "reference/chains/region_of.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/oracle/cell_sets.hpp"
#include "reference/oracle/set_by_pieces.hpp"

namespace oplus {

namespace {

Chain box_around(const Region& region) {
  return box_around(set_by_pieces(region).boundary).corners();
}

Region region_where(const std::vector<Segment>& segments,
                    const std::function<bool(const Point&)>& contains) {
  return region_of(regularized(set_where(segments, Boundary::closed, contains)));
}

/// What P leaves of the smallest box around it; nothing where P is a box.
Region rest_of_box(const Region& p) {
  const Region box = polygon(box_around(p));
  std::vector<Segment> all = edges(box);
  for (const Segment& e : edges(p)) all.push_back(e);
  return region_where(all, [&](const Point& x) {
    return locate(x, box) != Location::outside && locate(x, p) != Location::inside;
  });
}

Region complement_of(const Region& p) {
  return region_where(edges(p), [&](const Point& x) { return locate(x, p) != Location::inside; });
}

/// The union of Q + a for three vertices a of P's first chain; or for all points of the edges between them.
Region copies_along(const Region& q, const Region& p, bool is_along_edges) {
  const Chain chain = chains(p).front();
  SetByPieces places;
  if (is_along_edges)
    places.edges = {{chain[0], chain[1]}, {chain[1], chain[2]}};
  else
    places.points = {chain[0], chain[1], chain[2]};
  const SetByPieces set = set_by_pieces(q), minus_q = reflected(set);
  return region_where(vertex_edge_sum(places, set),
                      [&](const Point& x) { return meet(translated(minus_q, x), places); });
}

Rational size_of_box(const Region& region) {
  const Chain box = box_around(region);
  return box[2].x - box[0].x + box[2].y - box[0].y;
}

}  // namespace

FittingPair fitting_pair(const Summands& summands, std::size_t kind, bool second) {
  const auto& [p, q] = summands;
  const Region minus_q = reflected(q);
  const Region rest = kind == 1 || kind == 4 ? rest_of_box(p) : Region{};
  if (kind == 1 && rest.components.empty()) kind = 2;
  switch (kind) {
    case 0:
      return size_of_box(p) < size_of_box(q) ? FittingPair{"Q, P", {q, p}}
                                             : FittingPair{"P, Q", summands};
    case 1:
      return {"what P leaves of its box, -Q", {rest, minus_q}};
    case 2:
      return {"the complement of P, -Q", {complement_of(p), minus_q}};
    case 3:
      return {second ? "Q moved along two edges, Q" : "three copies of Q, Q",
              {copies_along(q, p, second), q}};
    default: {
      const Region outside = complement_of(rest.components.empty() ? p : rest);
      if (second)
        return {"the complements of -Q and of what P leaves of its box",
                {complement_of(minus_q), outside}};
      return {"-Q, the complement of what P leaves of its box", {minus_q, outside}};
    }
  }
}

}  // namespace oplus
