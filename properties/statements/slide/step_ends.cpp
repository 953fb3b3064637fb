// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/slide/slid_pair.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  slide::ShortList<slide::FreePiece<SlidPair::Numbers>> pieces = pair.free_pieces();
  const auto ends = slide::named_ends(pieces, pair.segments, pair.scaling, 1);
  std::vector<Point> points;
  for (const auto& x : ends.points) points.push_back(x.in_the_plane(pair.scaling));
  const auto is_on = [&](std::uint32_t i, const slide::BoundaryPiece& piece) {
    return slide::lies_between(ends.points[i], ends.points[piece.from], ends.points[piece.to],
                               pair.scaling);
  };
  const auto cut =
      slide::cut_at_points(slide::span_of(ends.pieces),
                           {is_on, slide::span_of(ends.near_x), slide::span_of(ends.near_y)}, 1);
  Outcome outcome;
  outcome.counts["free pieces"] = pieces.size();
  outcome.counts["pieces after cutting"] = cut.size();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (points[i] == points[j])
        return outcome.fail(
            "two ends at the same point have different "
            "numbers",
            points[i]);
  if (!std::is_sorted(points.begin(), points.end()))
    return outcome.fail("ends are not numbered in the order of the plane");
  std::vector<Segment> before, after;
  for (const auto& piece : pieces)
    before.push_back(
        {pair.point(piece.segment, piece.piece.from), pair.point(piece.segment, piece.piece.to)});
  for (const auto& piece : cut) after.push_back({points[piece.from], points[piece.to]});
  if (maximal_segments(before) != maximal_segments(after))
    return outcome.fail("the pieces after cutting do not cover the same points as before");
  for (const Segment& a : after)
    for (const Segment& b : after)
      for (const Point& x : {b.source, b.target})
        if (lies_on(x, a) && x != a.source && x != a.target)
          return outcome.fail("a piece ends inside another one", x);
  return outcome;
}

const Registered registered(small_mixture(), {.id = "step-ends",
                                              .kills = {"slide-pieces-stay-uncut"},
                                              .cases = 800,
                                              .check = check});

}  // namespace

}  // namespace oplus
