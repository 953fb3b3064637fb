// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/operations/set_sum.hpp"
#include "checked/operations/union_of.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/sets_meet.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The edges of a region's first chain: a closed polyline.
std::vector<Segment> first_polyline(const Region& region) {
  return edges(region.components[0].outer);
}

/// Polylines with each other and with regions, and a mixture: a region, two edges that leave its first
/// vertex, and points, with a region and one of the first's edges.
std::vector<std::pair<ClaimedSum, ClaimedSum>> pairs_of_sets(const Region& p, const Region& q) {
  const std::vector<Segment> line_p = first_polyline(p), line_q = first_polyline(q);
  std::vector<Segment> open_p = line_p;
  open_p.pop_back();
  const Vector to_p = line_p[0].source - line_q[0].source;
  ClaimedSum mixed{p, {}, {line_q[0].source, line_q[1].target}};
  for (std::size_t i = 0; i < 2; ++i)
    mixed.dangling_edges.push_back({line_q[i].source + to_p, line_q[i].target + to_p});
  return {{{p, {}, {}}, {{}, line_q, {}}},
          {{{}, open_p, {}}, {q, {}, {}}},
          {{{}, open_p, {}}, {{}, line_q, {line_p[0].source}}},
          {mixed, {q, {line_p[1]}, {midpoint(line_q[0].source, line_q[1].target)}}}};
}

/// Whether a dangling edge or an isolated vertex is outside the region that it is given with.
bool edges_and_points_are_outside(const PlanarSet& set) {
  PlanarSet region = set;
  region.dangling_edges.clear();
  region.isolated_vertices.clear();
  const auto is_outside = [&](const Point& p) { return locate(p, region) == Location::outside; };
  const std::vector<Segment> boundary = edges(region);
  for (const Segment& e : set.dangling_edges)
    for (const Segment& piece : cut_where_met(e, boundary))
      if (!is_outside(midpoint(piece.source, piece.target))) return false;
  return std::all_of(
      set.isolated_vertices.begin(), set.isolated_vertices.end(),
      [&](const Point& v) { return is_outside(v) && !lies_on_one(v, set.dangling_edges); });
}

void check(const ClaimedSum& p, const ClaimedSum& q, Outcome& outcome) {
  const auto set = [](const ClaimedSum& parts) {
    return union_of(parts.region, parts.dangling_edges, parts.isolated_vertices);
  };
  const PlanarSet closed = set_sum(set(p), set(q), Boundary::closed, by_slide);
  const PlanarSet open = set_sum(set(p), set(q), Boundary::open, by_slide);
  outcome.counts["closed sums with edges or points"] += has_edge_or_point(closed) ? 1 : 0;
  outcome.counts["open sums with edges or points"] += has_edge_or_point(open) ? 1 : 0;
  if (!edges_and_points_are_outside(closed)) {
    outcome.fail("a dangling edge or an isolated vertex is in the region of " + wkt(closed));
    return;
  }
  for (const Point& x : points_of_cells(p, q)) {
    ++outcome.counts["points"];
    const ClaimedSum placed = reflected_to(x, q);
    if (meet(p, placed) != (locate(x, closed) != Location::outside)) {
      outcome.fail(
          to_string(x) + " is wrong in the closed sum of " + wkt(set(p)) + " and " + wkt(set(q)),
          x);
      return;
    }
    const bool in_open = interior_meets(p.region, placed) || interior_meets(placed.region, p);
    if (in_open != (locate(x, open) == Location::inside)) {
      outcome.fail(
          to_string(x) + " is wrong in the open sum of " + wkt(set(p)) + " and " + wkt(set(q)), x);
      return;
    }
  }
}

Outcome check_sets(const Summands& summands) {
  Outcome outcome;
  for (const auto& [p, q] : pairs_of_sets(summands.p, summands.q)) {
    check(p, q, outcome);
    if (outcome.kind == Outcome::Kind::fails) break;
  }
  return outcome;
}

const Registered registered({
    .id = "fact-closed-sets",
    .sources = {{"grid", 8, 4}, {"tight", 3, 2}, {"components", 3, 1}},
    .promises = {{"parallel edges", 40}, {"reflex vertices", 10}},
    .kills = {"cycles-of-edges-are-trees", "open-sets-lose-edges", "points-inside-are-isolated",
              "regions-jump-along-edges", "segments-inside-dangle"},
    .cases = 50,
    .check = check_sets,
});

}  // namespace

}  // namespace oplus
