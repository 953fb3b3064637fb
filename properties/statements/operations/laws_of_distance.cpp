// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/distance/distance.hpp"
#include "checked/operations/operations.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/operations/places_of_q.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Of the origin from a closed set.
Rational squared_distance(const PlanarSet& set) {
  if (locate({}, set) != Location::outside) return 0;
  const std::vector<Segment> boundary = edges(set);
  Rational least = squared_distance({}, boundary.at(0));
  for (const Segment& edge : boundary) least = std::min(least, squared_distance({}, edge));
  return least;
}

Outcome check_distance(const Summands& summands) {
  Outcome outcome;
  for (std::size_t kind = 0; kind < fitting_kinds; ++kind) {
    const auto [how, pair] = fitting_pair(summands, kind);
    for (const Region& q : places_of_q(pair, 4)) {
      const auto [squared, on_p, on_q] = distance(pair.p, q);
      const PlanarSet sum = unbounded_sum(pair.p, reflected(q), Boundary::closed, by_slide);
      const Rational right = squared_distance(sum);
      ++outcome.counts[sgn(right) > 0                          ? "regions that are apart"
                       : locate({}, sum) == Location::boundary ? "regions that touch"
                                                               : "regions that overlap"];
      if (squared != right)
        return outcome.fail(how + ": the squared distance is " + to_string(right) + ", not " +
                            to_string(squared));
      if (squared_length(on_p - on_q) != squared)
        return outcome.fail(how + ": the points are not at the distance", on_p);
      if (locate(on_p, pair.p) == Location::outside || locate(on_q, q) == Location::outside)
        return outcome.fail(how + ": one of the points is not in its region", on_p);
    }
  }
  return outcome;
}

const Registered law_distance({
    .id = "law-distance",
    .sources = {{"tight", 2, 3}, {"grid", 5, 4}, {"holes", 4, 2}, {"components", 3, 3}},
    .promises = {{"holes", 10}, {"several components", 10}, {"parallel edges", 40}},
    .kills = {"distances-from-one-side", "distances-from-boundaries"},
    .cases = 50,
    .check = check_distance,
});

/// All moves of Q after which one of its vertices is on an edge of P, or an edge on a vertex of P.
std::vector<Segment> vertex_edge_moves(const Region& p, const Region& q) {
  std::vector<Segment> all;
  for (const Segment& a : edges(p))
    for (const Segment& b : edges(q)) {
      all.push_back({a.source - b.source, a.target - b.source});
      all.push_back({a.source - b.source, a.source - b.target});
    }
  return all;
}

/// A move shorter than another one after which the interiors don't meet. The shortest of these is where two of the
/// segments meet, an end of one, or where one is nearest to the origin: between such points, all moves are alike.
std::optional<Vector> shorter_move(const Region& p, const Region& q, const Rational& squared) {
  std::vector<Segment> near;
  for (Segment& s : vertex_edge_moves(p, q))
    if (squared_distance({}, s) < squared) near.push_back(std::move(s));
  std::vector<Point> tried;
  for (const Segment& s : near) tried.push_back(nearest_point({}, s));
  for (const std::vector<Segment>& pieces : cut_at_intersections(near))
    for (const Segment& piece : pieces) {
      tried.push_back(piece.source);
      tried.push_back(piece.target);
    }
  for (const Point& x : sorted_without_copies(std::move(tried)))
    if (squared_length(x) < squared && !interiors_meet(p, translated(q, x))) return x;
  return std::nullopt;
}

std::string defect(const Region& p, const Region& q, const Overlap& overlap) {
  const auto& [move, squared, contact] = overlap;
  const Region moved = translated(q, move);
  if (squared_length(move) != squared) return "the move has another length";
  if (interiors_meet(p, moved)) return "the regions overlap after the move " + to_string(move);
  if (locate(contact, p) == Location::outside || locate(contact, moved) == Location::outside)
    return "the contact " + to_string(contact) + " is not in both regions";
  if (const std::optional<Vector> shorter = shorter_move(p, q, squared))
    return "the move " + to_string(*shorter) + " is shorter than " + to_string(move);
  return "";
}

bool is_moved_apart(const Region& p, const Region& q) {
  try {
    depth(p, q);
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

Outcome check_depth(const Summands& summands) {
  Outcome outcome;
  bool has_exact_fit = false;
  for (std::size_t kind = 0; kind < fitting_kinds; ++kind) {
    if (kind == 3) continue;  // P is large there
    const auto [how, pair] = fitting_pair(summands, kind);
    PlanarSet plane;
    plane.is_unbounded = true;
    if (no_fit(pair.p, pair.q, by_slide) == plane) {
      ++outcome.counts["pairs that overlap after all moves"];
      if (is_moved_apart(pair.p, pair.q))
        return outcome.fail(how + ": they overlap after all moves");
      continue;
    }
    for (const Region& q : places_of_q(pair, 1)) {
      const std::optional<Overlap> overlap = depth(pair.p, q);
      ++outcome.counts[overlap ? "overlaps" : "regions that don't overlap"];
      if (overlap.has_value() != interiors_meet(pair.p, q))
        return outcome.fail(how + (overlap ? ": there is no overlap" : ": there is an overlap"));
      if (!overlap) continue;
      const std::string what = defect(pair.p, q, *overlap);
      if (!what.empty()) return outcome.fail(how + ": " + what);
      const Region further = translated(q, Rational(1001, 1000) * overlap->move);
      has_exact_fit = has_exact_fit || interiors_meet(pair.p, further);
    }
  }
  outcome.counts["cases with ways out that lead to exact fits"] = has_exact_fit;
  return outcome;
}

const Registered law_depth({
    .id = "law-depth",
    .sources = {{"tight", 2, 6}, {"grid", 4, 3}, {"holes", 3, 1}, {"components", 3, 1}},
    .promises = {{"cases with ways out that lead to exact fits", 10},
                 {"holes", 10},
                 {"parallel edges", 40}},
    .kills = {"nearest-boundary-misses-exact-fits"},
    .cases = 50,
    .check = check_depth,
});

}  // namespace

}  // namespace oplus
