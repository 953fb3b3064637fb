// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ranges>
#include <set>

#include "properties/runner/registry.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Whether x is the sum of a point inside a piece of an edge of P and one of Q, in equal directions
/// and in different ones. The edges of -Q + x are those of Q reversed.
struct SumsOfInsidePoints {
  bool equal = false;
  bool different = false;
};

SumsOfInsidePoints sums_of_inside_points(const Region& p, const Region& placed) {
  SumsOfInsidePoints found;
  const std::vector<Segment> of_q = boundary_pieces(placed);
  for (const Segment& s : boundary_pieces(p)) {
    for (const Segment& t : of_q) {
      if (cross_properly(s, t)) found.different = true;
      if (!overlap(s, t)) continue;
      const bool is_same = sign(dot(direction_of(s), direction_of(t))) > 0;
      (is_same ? found.different : found.equal) = true;
    }
  }
  return found;
}

/// Sums of middles and quarters of pieces: on a grid, many of them are placements where more than
/// these two pieces meet.
std::set<Point> sums_of_some_inside_points(const Summands& summands) {
  std::set<Point> sums;
  const std::vector<Segment> of_q = boundary_pieces(summands.q);
  for (const Segment& s : boundary_pieces(summands.p)) {
    const Point middle = midpoint(s.source, s.target);
    for (const Segment& t : of_q) {
      const Point middle_of_t = midpoint(t.source, t.target);
      sums.insert({middle + middle_of_t, midpoint(s.source, middle) + middle_of_t});
    }
  }
  return sums;
}

constexpr std::size_t most_sums = 20;  // per pair

Outcome check(const Summands& summands) {
  Outcome outcome;
  const Region reflected_q = reflected(summands.q);
  const std::set<Point> sums_of_points = sums_of_some_inside_points(summands);
  const std::vector<Point> all(sums_of_points.begin(), sums_of_points.end());
  const std::size_t looked_at = std::min(all.size(), most_sums);
  for (std::size_t k = 0; k < looked_at; ++k) {
    const Point& x = all[k * all.size() / looked_at];
    const Region placed = translated(reflected_q, x);
    const SumsOfInsidePoints sums = sums_of_inside_points(summands.p, placed);
    ++outcome.counts["sums of points inside edges"];
    const bool is_in_sum = std::ranges::any_of(
        overlaid({summands.p, placed}),
        [](const OverlaidPoint& a) { return a.is_in(0, true) && a.is_in(1, true); });
    if (!is_in_sum) ++outcome.counts["of them, not in the open sum"];
    if (sums.different && !is_in_sum) {
      outcome.fail(to_string(x) +
                       " is a sum of points inside edges of different directions, but "
                       "not in the open sum",
                   x);
    } else if (interiors_meet(summands.p, placed) != is_in_sum) {
      outcome.fail("at " + to_string(x) + " the collision test says that the interiors " +
                       (is_in_sum ? "do not meet, and they do" : "meet, and they do not"),
                   x);
    }
    if (outcome.kind == Outcome::Kind::fails) break;
  }
  return outcome;
}

const Registered registered({
    .id = "lemma-2.2.5",
    .sources = {{"grid", 5, 4}, {"tight", 1, 1}, {"holes", 3, 5}, {"components", 3, 2}},
    .promises =
        {{"holes", 15}, {"several components", 5}, {"reflex vertices", 10}, {"parallel edges", 40}},
    .kills = {"edges-are-not-cut-where-chains-touch", "parallel-edges-do-not-collide"},
    .cases = 80,
    .check = check,
});

}  // namespace

}  // namespace oplus
