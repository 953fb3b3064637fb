// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/low_dimensional_candidates.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/places/covered_sum.hpp"
#include "properties/statements/slide/slid_pair.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  const slide::Candidates candidates =
      slide::low_dimensional_candidates(pair.tracks, pair.free_pieces(), pair.scaling, 1);
  const MinkowskiSum open = oracle_sums(summands.p, summands.q).open;
  Outcome outcome;
  outcome.counts["candidate pieces"] = candidates.pieces.size();
  outcome.counts["candidate points"] = candidates.points.size();
  outcome.counts["dangling edges"] = open.dangling_edges.size();
  outcome.counts["isolated vertices"] = open.isolated_vertices.size();
  std::vector<Segment> segments;
  for (const auto& piece : candidates.pieces) {
    segments.push_back(piece.segment);
    // Two more places, on both sides of the one that decides.
    const bool is_in_sum = pair.interiors_meet_at(piece.inside);
    for (const Point& end : {piece.segment.source, piece.segment.target})
      if (pair.interiors_meet_at(midpoint(piece.inside, end)) != is_in_sum)
        return outcome.fail("a candidate piece is in the open sum in part", piece.inside);
  }
  for (const Segment& edge : open.dangling_edges)
    if (!cover(segments, edge))
      return outcome.fail("a dangling edge is not covered", midpoint(edge.source, edge.target));
  std::set<Point> points = sums_of_touching_points(summands);
  points.insert(candidates.points.begin(), candidates.points.end());
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
        "summand touch; and each candidate piece is in the open sum as a whole or not at all.",
    .why = "A dangling edge or isolated vertex is on segments of the reduced convolution and "
           "surrounded by the sum. Edges of P and -Q + x(t), not shifted, do not cross properly "
           "there, so it is in a closed piece that no pair of edges blocks. Along a segment, the "
           "contact of two edges begins and ends where x(t) enters and leaves the sum of the two "
           "edges. Between two such places all contacts stay the same, so either all points there "
           "are in the open sum or none is. An isolated vertex differs from its neighbours on the "
           "segment, so it is one of these places.",
    .hypotheses = {"P and Q are valid regions"},
    .rests_on = {"step-interval", "theorem-3.2.8", "theorem-3.2.10"},
    .sources =
        {{"tight", 6, 4}, {"grid", 6, 2}, {"holes", 4, 2}, {"components", 4, 1}, {"islands", 2, 1}},
    .promises = {{"parallel edges", 40}, {"holes", 10}},
    .kills = {"slide-forgets-changes-of-contact"},
    .cases = 250,
    .check = check,
});

}  // namespace

}  // namespace oplus
