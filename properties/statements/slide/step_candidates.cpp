// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/low_dimensional_features.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/covered_sum.hpp"
#include "properties/statements/slide/slid_pair.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

slide::OpenCandidates<SlidPair::Numbers> candidates_of(const SlidPair& pair) {
  const auto rays = slide::rays_of(pair.segments.summands());
  slide::FreePieces<SlidPair::Numbers> closed(pair.segments.summands());
  slide::OpenPlaces<SlidPair::Numbers> open(pair.segments.summands(), rays);
  for (std::uint32_t i = 0; i < pair.segments.size(); ++i)
    if (!slide::right_is_enough(rays) || slide::is_to_the_right(pair.segments.direction(i)))
      open.find(closed, i, pair.segments[i], [](const SlidPair::Piece&) {});
  return slide::low_dimensional_candidates(pair.segments, rays, std::move(open.found), 1);
}

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  const PlanarSet open = oracle_sums(summands.p, summands.q).open;
  Outcome outcome;
  std::vector<Segment> segments;
  std::set<Point> points = sums_of_touching_points(summands);
  const auto candidates = candidates_of(pair);
  outcome.counts["candidate points"] = candidates.points.size();
  outcome.counts["candidate pieces"] = candidates.pieces.size();
  for (const auto& [segment, piece] : candidates.points)
    points.insert(pair.point(segment, piece.from));
  for (const auto& [segment, piece] : candidates.pieces) {
    const Point from = pair.point(segment, piece.from), to = pair.point(segment, piece.to);
    segments.push_back({from, to});
    // Two more places, on both sides of the one that decides.
    const Point inside = pair.point(segment, slide::place_inside(piece));
    const bool is_in_sum = pair.interiors_meet_at(inside);
    for (const Point& end : {from, to})
      if (pair.interiors_meet_at(midpoint(inside, end)) != is_in_sum)
        return outcome.fail("a candidate piece is in the open sum in part", inside);
  }
  outcome.counts["dangling edges"] = open.dangling_edges.size();
  outcome.counts["isolated vertices"] = open.isolated_vertices.size();
  for (const Segment& edge : open.dangling_edges)
    if (!cover(segments, edge))
      return outcome.fail("a dangling edge is not covered", midpoint(edge.source, edge.target));
  for (const Point& x : open.isolated_vertices)
    if (!points.contains(x)) return outcome.fail("an isolated vertex is not a candidate", x);
  return outcome;
}

const Registered registered({
    .id = "step-candidates",
    .sources =
        {{"tight", 6, 4}, {"grid", 6, 2}, {"holes", 4, 2}, {"components", 4, 1}, {"islands", 2, 1}},
    .promises = {{"parallel edges", 40}, {"holes", 10}},
    .kills = {"slide-ignores-weak-intersections"},
    .cases = 100,
    .check = check,
});

}  // namespace

}  // namespace oplus
