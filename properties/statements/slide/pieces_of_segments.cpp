// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/blocked_interval.hpp"
#include "checked/slide/contact_interval.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/slide/slid_pair.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Outcome check_segments(const Summands& summands) {
  const SlidPair pair(summands);
  std::vector<Origin> found, defined;
  for (std::uint32_t i = 0; i < pair.segments.size(); ++i) found.push_back(pair.segments.origin(i));
  for (const ConvolutionSegment& s : reduced_convolution(summands.p, summands.q))
    defined.push_back(s.origin);
  std::sort(found.begin(), found.end());
  std::sort(defined.begin(), defined.end());
  Outcome outcome;
  outcome.counts["segments"] = found.size();
  if (found != defined) {
    outcome.fail(counted(found.size(), "segment", "segments") + " by ranks, " +
                 std::to_string(defined.size()) + " by the definition");
  }
  return outcome;
}

const Registered step_segments(small_mixture(), {.id = "step-segments",
                                                 .kills = {"slide-ranks-without-ties"},
                                                 .cases = 600,
                                                 .check = check_segments});

Outcome check_interval(const Summands& summands) {
  const SlidPair pair(summands);
  const auto& p = pair.segments.summands().p.edges;
  const auto& q = pair.segments.summands().q.edges;
  const std::vector<Segment> of_p = edges(summands.p);
  const std::vector<Segment> of_q = edges(reflected(summands.q));
  Outcome outcome;
  // All pairs of edges, on about four segments; which ones depends on the size of P.
  const std::uint32_t step = 1 + static_cast<std::uint32_t>(pair.segments.size() / 4);
  for (std::uint32_t i = static_cast<std::uint32_t>(of_p.size()) % step; i < pair.segments.size();
       i += step) {
    const auto segment = pair.segments[i].exact;
    for (std::size_t a = 0; a < p.size(); ++a) {
      for (std::size_t b = 0; b < q.size(); ++b) {
        const auto blocked =
            slide::blocked_interval(segment, p[a], q[b], slide::Shift::to_the_right);
        const auto contact = slide::contact_interval(segment, p[a], q[b]);
        std::vector<SlidPair::Place> ends;
        if (blocked) ends.insert(ends.end(), {blocked->from, blocked->to});
        if (contact) ends.insert(ends.end(), {contact->from, contact->to});
        for (const SlidPair::Place& t : pair.between(ends)) {
          ++outcome.counts["places"];
          const bool is_blocked = blocked && blocked->from < t && t < blocked->to;
          outcome.counts["places where they cross"] += is_blocked;
          const Point x = pair.shifted(i, t);
          const Segment moved{of_q[b].source + x, of_q[b].target + x};
          if (cross_properly(of_p[a], moved) == is_blocked) continue;
          return outcome.fail("at " + to_string(pair.point(i, t)) + " on segment " +
                                  std::to_string(i) + " edge " + std::to_string(a) +
                                  " of P and edge " + std::to_string(b) + " of Q " +
                                  (is_blocked ? "do not cross, and the interval says that they do"
                                              : "cross, and the interval says that they do not"),
                              pair.point(i, t));
        }
      }
    }
  }
  return outcome;
}

const Registered step_interval(small_mixture(), {.id = "step-interval",
                                                 .kills = {"slide-shifts-to-the-left"},
                                                 .cases = 500,
                                                 .check = check_interval});

Outcome check_ends(const Summands& summands) {
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

const Registered step_ends(small_mixture(), {.id = "step-ends",
                                             .kills = {"slide-pieces-stay-uncut"},
                                             .cases = 800,
                                             .check = check_ends});

}  // namespace

}  // namespace oplus
