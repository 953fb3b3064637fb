// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/slide/blocked_interval.hpp"
#include "checked/slide/blocking_search.hpp"
#include "checked/slide/component_test.hpp"
#include "checked/slide/contact_interval.hpp"
#include "checked/slide/exact_point.hpp"
#include "checked/slide/free_pieces.hpp"
#include "checked/slide/low_dimensional_features.hpp"
#include "checked/slide/named_ends.hpp"
#include "checked/slide/place_inside.hpp"
#include "checked/slide/reduced_segments.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/covered_sum.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/families/family.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

slide::Scaling scaling_of_pair(const Summands& pair) {
  return slide::scaling_of(slide::extent_of(pair.p, slide::Denominators::any),
                           slide::extent_of(pair.q, slide::Denominators::any));
}

/// A pair as slide prepares it, in 64-bit integers.
struct SlidPair {
  using Numbers = slide::SmallNumbers;
  using Place = slide::Fraction<Numbers>;
  using ReducedSegment = slide::ReducedSegment<Numbers>;
  using Piece = slide::Piece<Numbers>;

  /// Requires: coordinates of at most 29 bits.
  explicit SlidPair(const Summands& pair);

  Point point(std::uint32_t segment, const Place& t) const;

  Vector direction(std::uint32_t segment) const;

  /// x(t), shifted to the right of the segment: by so little that no sign changes that was not
  /// zero.
  Point shifted(std::uint32_t segment, const Place& t) const;

  /// By the definition: whether the interiors of P and -Q + x meet.
  bool interiors_meet_at(const Point& x) const;

  /// A place of each part into which the given places cut the segment, between two of them; the places
  /// need be neither sorted nor different.
  std::vector<Place> between(std::vector<Place> places) const;

  /// What slide finds free, segment by segment.
  slide::ShortList<slide::FreePiece<Numbers>> free_pieces() const;

  const Summands& summands;
  slide::Scaling scaling;
  slide::ReducedSegments<Numbers> segments;

 private:
  Region minus_q_;
};

SlidPair::SlidPair(const Summands& pair)
    : summands(pair),
      scaling(scaling_of_pair(pair)),
      segments(pair.p, pair.q, scaling),
      minus_q_(reflected(pair.q)) {
  OPLUS_REQUIRES(scaling.bits <= Numbers::bits, "coordinates of 29 bits");
}

Point SlidPair::point(std::uint32_t segment, const Place& t) const {
  return slide::ExactPoint<Numbers>(segments[segment].exact, t).in_the_plane(scaling);
}

Vector SlidPair::direction(std::uint32_t segment) const {
  const auto& d = segments.direction(segment);
  return {Rational(d.x), Rational(d.y)};
}

Point SlidPair::shifted(std::uint32_t segment, const Place& t) const {
  // Places have denominators of less than 64 bits and coordinates less than 30 bits, so that a skew
  // product that is not zero is larger than 2^-200.
  static const Rational little = [] {
    mpz_class large;
    mpz_ui_pow_ui(large.get_mpz_t(), 2, 500);
    return Rational(1, large);
  }();
  const Vector d = direction(segment);
  return point(segment, t) + little * Vector{d.y, -d.x};
}

bool SlidPair::interiors_meet_at(const Point& x) const {
  return interiors_meet(summands.p, translated(minus_q_, x));
}

std::vector<SlidPair::Place> SlidPair::between(std::vector<Place> places) const {
  std::erase_if(places, [](const Place& t) { return !(Place{0, 1} < t) || !(t < Place{1, 1}); });
  places.push_back({0, 1});
  places.push_back({1, 1});
  std::sort(places.begin(), places.end());
  std::vector<Place> inside;
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i - 1] < places[i])
      inside.push_back(slide::place_inside(Piece{places[i - 1], places[i]}));
  return inside;
}

slide::ShortList<slide::FreePiece<SlidPair::Numbers>> SlidPair::free_pieces() const {
  slide::FreePieces<Numbers> search(segments.summands());
  slide::ShortList<slide::FreePiece<Numbers>> pieces;
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    search.find(segments[i], [&](Piece piece) { pieces.push_back({i, std::move(piece)}); });
  return pieces;
}

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

slide::OpenCandidates<SlidPair::Numbers> candidates_of(const SlidPair& pair) {
  const auto rays = slide::rays_of(pair.segments.summands());
  slide::FreePieces<SlidPair::Numbers> closed(pair.segments.summands());
  slide::OpenPlaces<SlidPair::Numbers> open(pair.segments.summands(), rays);
  for (std::uint32_t i = 0; i < pair.segments.size(); ++i)
    if (!slide::right_is_enough(rays) || slide::is_to_the_right(pair.segments.direction(i)))
      open.find(closed, i, pair.segments[i], [](const SlidPair::Piece&) {});
  return slide::low_dimensional_candidates(pair.segments, rays, std::move(open.found), 1);
}

Outcome check_candidates(const Summands& summands) {
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

const Registered step_candidates({
    .id = "step-candidates",
    .sources =
        {{"tight", 6, 4}, {"grid", 6, 2}, {"holes", 4, 2}, {"components", 4, 1}, {"islands", 2, 1}},
    .promises = {{"parallel edges", 40}, {"holes", 10}},
    .kills = {"slide-ignores-weak-intersections"},
    .cases = 100,
    .check = check_candidates,
});

/// Adds to `outcome` what the search finds, by boxes or in the table of all pairs.
template <typename Numbers>
void compare(const Summands& pair, std::size_t most_pairs, Outcome& outcome) {
  using Place = slide::Fraction<Numbers>;
  using Piece = slide::Piece<Numbers>;
  const slide::Scaling scaling = scaling_of_pair(pair);
  const slide::ReducedSegments<Numbers> segments(pair.p, pair.q, scaling);
  slide::IntegerSummands<Numbers> integers(pair.p, pair.q, scaling, most_pairs);
  integers.prepare_component_test();
  slide::FreePieces<Numbers> search(integers);
  const slide::ComponentTest<Numbers> components(integers);
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const slide::ReducedSegment<Numbers> segment = segments[i];
    std::vector<Piece> found, defined;
    search.find(segment, [&](Piece piece) { found.push_back(std::move(piece)); });
    std::vector<slide::BlockedInterval<Numbers>> intervals;
    for (const auto& e : integers.p.edges)
      for (const auto& f : integers.q.edges)
        if (auto blocked = slide::blocked_interval(segment.exact, e, f, slide::Shift::to_the_right))
          intervals.push_back(*blocked);
    std::vector<Place> ends = {{0, 1}, {1, 1}};
    for (const auto& interval : intervals) ends.insert(ends.end(), {interval.from, interval.to});
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 1; k < ends.size(); ++k) {
      if (!(ends[k - 1] < ends[k]) || ends[k - 1] < Place{0, 1} || Place{1, 1} < ends[k]) continue;
      const Piece piece{ends[k - 1], ends[k]};
      const Place t = slide::place_inside(piece);
      const bool is_blocked =
          std::any_of(intervals.begin(), intervals.end(),
                      [&](const auto& interval) { return interval.from < t && t < interval.to; });
      if (is_blocked || components.overlap_at(segment, t)) continue;
      defined.push_back(piece);
    }
    std::sort(found.begin(), found.end(),
              [](const Piece& a, const Piece& b) { return a.from < b.from; });
    outcome.counts["segments"] += 1;
    outcome.counts["free pieces"] += found.size();
    const auto same = [](const Piece& a, const Piece& b) {
      return !(a.from < b.from) && !(b.from < a.from) && !(a.to < b.to) && !(b.to < a.to);
    };
    if (std::equal(found.begin(), found.end(), defined.begin(), defined.end(), same)) continue;
    outcome.fail("segment " + std::to_string(i) + " has " + std::to_string(found.size()) +
                 " free pieces by search" +
                 (integers.pairs.is_empty() ? " in boxes, " : " in the table, ") +
                 std::to_string(defined.size()) + " by all pairs");
    return;
  }
  outcome.counts["segments inside a convex summand, moved"] += search.effort().covered;
}

Outcome check_search(const Summands& summands) {
  // Doubles see one summand as a point beside the other one.
  static const Rational far((mpz_class(1) << 1500) / 3);
  const auto enlarge = [](const Point& x) { return Point{far * x.x, far * x.y}; };
  Outcome outcome;
  compare<SlidPair::Numbers>(summands, 0, outcome);
  if (outcome.kind == Outcome::Kind::holds)
    compare<SlidPair::Numbers>(summands, slide::few_pairs, outcome);
  if (outcome.kind == Outcome::Kind::holds)
    compare<slide::AnyNumbers>({summands.p, mapped(summands.q, enlarge)}, 0, outcome);
  return outcome;
}

const Registered step_search(small_mixture(),
                             {.id = "step-search",
                              .kills = {"slide-covers-with-closed-summands",
                                        "slide-leaves-boxes-out", "slide-passes-sides-by",
                                        "slide-takes-the-other-corner"},
                              .cases = 1000,
                              .check = check_search});

Outcome check_components(const Summands& summands) {
  const SlidPair pair(summands);
  slide::IntegerSummands<SlidPair::Numbers> integers(summands.p, summands.q, pair.scaling);
  integers.prepare_component_test();  // also where there is one component
  const slide::ComponentTest<SlidPair::Numbers> components(integers);
  slide::BlockingSearch<SlidPair::Numbers> search(integers, slide::Shift::to_the_right);
  Outcome outcome;
  const auto fail = [&](std::uint32_t segment, const SlidPair::Place& t, const std::string& what) {
    const Point x = pair.point(segment, t);
    return outcome.fail(
        "at " + to_string(x) + " on segment " + std::to_string(segment) + " " + what, x);
  };
  const std::uint32_t step = 1 + static_cast<std::uint32_t>(pair.segments.size() / 8);
  for (std::uint32_t i = 0; i < pair.segments.size(); i += step) {
    const SlidPair::ReducedSegment segment = pair.segments[i];
    std::vector<SlidPair::Place> ends;
    for (const auto& e : integers.p.edges)
      for (const auto& f : integers.q.edges)
        if (const auto contact = slide::contact_interval(segment.exact, e, f))
          ends.insert(ends.end(), {contact->from, contact->to});
    for (const SlidPair::Place& t : pair.between(ends)) {
      if (search.at(segment, t)) continue;
      const bool overlap = components.overlap_at(segment, t);
      ++outcome.counts["places where no edges cross"];
      outcome.counts["places where components overlap"] += overlap;
      if (pair.interiors_meet_at(pair.shifted(i, t)) != overlap)
        return fail(i, t,
                    overlap ? "components are found to overlap, and do not"
                            : "components overlap, and are found not to");
      if (overlap && !components.is_needed())
        return fail(i, t, "components of connected regions overlap");
    }
  }
  return outcome;
}

const Registered step_components({
    .id = "step-components",
    .sources =
        {{"components", 5, 4}, {"islands", 2, 2}, {"holes", 5, 2}, {"grid", 8, 2}, {"tight", 6, 2}},
    .promises = {{"several components", 30}, {"holes", 20}},
    .kills = {"slide-components-never-overlap"},
    .cases = 800,
    .check = check_components,
});

Outcome check_boundary(const Summands& summands) {
  const SlidPair pair(summands);
  const PlanarSet sum = oracle_sums(summands.p, summands.q).closed;
  const std::vector<Segment> boundary = edges(sum);
  slide::FreePieces<SlidPair::Numbers> search(pair.segments.summands());
  Outcome outcome;
  std::vector<Segment> free;
  for (std::uint32_t i = 0; i < pair.segments.size(); ++i) {
    std::vector<SlidPair::Piece> pieces;
    search.find(pair.segments[i], [&](auto piece) { pieces.push_back(std::move(piece)); });
    std::vector<SlidPair::Place> ends;
    for (const auto& piece : pieces) {
      ends.insert(ends.end(), {piece.from, piece.to});
      free.push_back({pair.point(i, piece.from), pair.point(i, piece.to)});
    }
    for (const SlidPair::Place& t : pair.between(ends)) {
      const bool is_free = std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) {
        return piece.from < t && t < piece.to;
      });
      const Point x = pair.point(i, t);
      const bool is_boundary =
          std::any_of(boundary.begin(), boundary.end(), [&](const Segment& edge) {
            return lies_on(x, edge) && sign(dot(direction_of(edge), pair.direction(i))) > 0 &&
                   sign(cross(direction_of(edge), pair.direction(i))) == 0;
          });
      ++outcome.counts[is_free ? "places in free pieces" : "places elsewhere"];
      if (is_free == is_boundary) continue;
      return outcome.fail(
          std::string(is_free ? "a free place is not on" : "a blocked place is on") +
              " the boundary, on segment " + std::to_string(i),
          x);
    }
  }
  for (const Segment& edge : boundary) {
    std::vector<Segment> equally_directed;
    for (const Segment& piece : free)
      if (sign(dot(direction_of(piece), direction_of(edge))) > 0) equally_directed.push_back(piece);
    ++outcome.counts["edges of the boundary"];
    if (cover(equally_directed, edge)) continue;
    return outcome.fail("an edge of the boundary is not covered by free pieces",
                        midpoint(edge.source, edge.target));
  }
  return outcome;
}

const Registered step_boundary({
    .id = "step-boundary",
    .sources = {{"grid", 6, 4},
                {"tight", 6, 3},
                {"holes", 4, 2},
                {"components", 4, 2},
                {"islands", 2, 1},
                {"fork", 2, 1}},
    .promises = {{"holes", 10}, {"parallel edges", 40}},
    .kills = {"slide-shifts-to-the-left", "slide-components-never-overlap"},
    .cases = 100,
    .check = check_boundary,
});

}  // namespace

}  // namespace oplus
