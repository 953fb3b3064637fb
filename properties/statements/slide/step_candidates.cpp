// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/low_dimensional_features.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/places/covered_sum.hpp"
#include "properties/statements/slide/slid_pair.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

slide::OpenCandidates<SlidPair::Numbers> candidates_of(const SlidPair& pair) {
  const auto rays = slide::rays_of(pair.tracks.summands());
  slide::FreePieces<SlidPair::Numbers> closed(pair.tracks.summands());
  slide::OpenPlaces<SlidPair::Numbers> open(pair.tracks.summands(), rays);
  for (std::uint32_t i = 0; i < pair.tracks.size(); ++i)
    if (!slide::right_is_enough(rays) || slide::is_to_the_right(pair.tracks.direction(i)))
      open.find(closed, i, pair.tracks[i], [](const SlidPair::Piece&) {});
  return slide::low_dimensional_candidates(pair.tracks, rays, std::move(open.found), 1);
}

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  const MinkowskiSum open = oracle_sums(summands.p, summands.q).open;
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
    .title = "Dangling edges and isolated vertices are among the candidates",
    .statement =
        "Every dangling edge of the open sum is covered by candidate pieces of slide, every "
        "isolated vertex is a candidate point or the sum of points in which chains of each "
        "summand touch; and each candidate piece is in the open sum as a whole or not at all. "
        "Segments to the right and straight up are enough, if the chains of one summand do not touch.",
    .why =
        "A dangling edge or isolated vertex is on segments of the reduced convolution and surrounded "
        "by the sum. It is in a closed piece on which no pair of edges shows that interiors meet: by "
        "a proper crossing, or by a common sector at a vertex of one that slides along an edge of "
        "the other. Where no pair does so between two places, and some place between them is in the "
        "open sum, a chain is inside the other interior there. Let it stay so up to a place that is "
        "not in the open sum. There the chain is in the closed summand, so on its boundary, and "
        "the two are on different sides of it; but just before, a part of it was on the inside of "
        "itself, and that part is in both interiors. So this place does not exist: the piece is in "
        "the open sum as a whole, or, since the open sum is open, not at all. An isolated vertex is "
        "not in such a piece, so it is a piece by itself.",
    .hypotheses = {"P and Q are valid regions"},
    .rests_on = {"step-interval", "theorem-3.2.8", "theorem-3.2.10"},
    .sources =
        {{"tight", 6, 4}, {"grid", 6, 2}, {"holes", 4, 2}, {"components", 4, 1}, {"islands", 2, 1}},
    .promises = {{"parallel edges", 40}, {"holes", 10}},
    .kills = {"slide-ignores-weak-intersections"},
    .cases = 250,
    .check = check,
});

}  // namespace

}  // namespace oplus
