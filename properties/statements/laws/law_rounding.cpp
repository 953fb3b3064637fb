// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/rounding/rounding.hpp"
#include "checked/rounding/snap_rounding.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/closeness.hpp"
#include "checked/verify/overlay.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Whether a pixel contains a point of a segment, by the definition: the middle of what the segment has in common
/// with the square and all its sides is in the pixel, if any point is.
bool is_passed(const Segment& s, const Point& centre, const Rational& step) {
  const Rational half = step / 2;
  const Chain square = {{centre.x - half, centre.y - half},
                        {centre.x + half, centre.y - half},
                        {centre.x + half, centre.y + half},
                        {centre.x - half, centre.y + half}};
  std::vector<Point> common;
  for (const Point& end : {s.source, s.target})
    if (abs(end.x - centre.x) <= half && abs(end.y - centre.y) <= half) common.push_back(end);
  for (const Segment& side : edges(square))
    for (const Point& p : intersection(s, side)) common.push_back(p);
  if (common.empty()) return false;
  const auto [first, last] = std::ranges::minmax_element(common);
  return nearest_grid_point(midpoint(*first, *last), step) == centre;
}

/// Whether all of a set is in another one; a point that shows it if not.
std::optional<Point> point_outside(const PlanarSet& set, const PlanarSet& other) {
  const Overlay overlay(given(other), set);
  for (const Overlay::Difference& difference : overlay.differences())
    if (difference.reason.in_given && !difference.reason.in_sum)
      return difference.boundary.front().source;
  return std::nullopt;
}

/// A point of a dangling edge or an isolated vertex that is inside another set.
std::optional<Point> feature_inside(const PlanarSet& set, const PlanarSet& other) {
  std::vector<Point> points = set.isolated_vertices;
  const std::vector<Segment> boundary = edges(other);
  for (const Segment& e : set.dangling_edges)
    for (const Segment& piece : cut_where_met(e, boundary))
      points.push_back(midpoint(piece.source, piece.target));
  const auto found = std::ranges::find_if(
      points, [&](const Point& p) { return locate(p, other) == Location::inside; });
  return found == points.end() ? std::nullopt : std::optional(*found);
}

/// Each edge is routed through the pixels that contain a point of it and of a vertex.
Outcome routed(const PlanarSet& sum, const Rational& step) {
  std::vector<Point> vertices;
  for (const Segment& e : edges(sum)) vertices.push_back(e.source);
  const HotPixels hot(vertices, step);
  Outcome outcome;
  for (const Segment& e : edges(sum)) {
    const std::vector<Point> passed = hot.passed(e);
    for (const Point& vertex : vertices) {
      const Point centre = nearest_grid_point(vertex, step);
      const bool is_there = std::ranges::count(passed, centre) > 0;
      ++outcome.counts["edges and hot pixels"];
      if (is_there != is_passed(e, centre, step))
        return outcome.fail("the edge from " + to_string(e.source) + " to " + to_string(e.target) +
                                (is_there ? " is routed through " : " is not routed through ") +
                                to_string(centre),
                            centre);
    }
  }
  return outcome;
}

Outcome rounded_to(const PlanarSet& sum, Boundary boundary, const Rational& step, Side side) {
  const RoundedSet result = rounded(sum, boundary, step, side);
  Outcome outcome;
  ++outcome.counts[result.is_exact ? "sums on the grid" : "rounded sums"];
  if (result.changes != TopologyChanges{}) ++outcome.counts["changes of components and holes"];
  if (const std::optional<Defect> defect = find_defect(result.region))
    return outcome.fail("the result is invalid: " + describe(defect->kind), defect->where);
  for (const Segment& e : edges(result.set))
    if (!is_on_grid(e.source, step) || !is_on_grid(e.target, step))
      return outcome.fail("a vertex is not on the grid", e.source);
  const bool contains = side == Side::contain, is_contained = side == Side::contained;
  if (const auto x = contains ? point_outside(result.set, sum) : std::nullopt)
    return outcome.fail("the result does not contain the sum", *x);
  if (const auto x = is_contained ? point_outside(sum, result.set) : std::nullopt)
    return outcome.fail("the result is not contained in the sum", *x);
  if (const auto x = is_contained ? feature_inside(sum, result.set) : std::nullopt)
    return outcome.fail("the result contains a point where Q just fits", *x);
  if (!rounded(result.set, boundary, step, side).is_exact)
    return outcome.fail("rounding twice is not rounding once");
  PlanarSet exact = sum;
  if (contains && !result.is_exact) {
    exact.dangling_edges.clear();
    exact.isolated_vertices.clear();
  }
  const Rational root_of_two(99, 70);
  if (!closeness(exact, {result.region, result.set.dangling_edges, result.set.isolated_vertices},
                 result.bound * root_of_two)
           .is_close())
    return outcome.fail("the result is not as close as promised");
  return outcome;
}

Outcome check(const Summands& summands) {
  Outcome all;
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const PlanarSet sum = slide_sum(summands.p, summands.q, boundary).sum;
    // Integers are on sides of pixels where they are odd.
    for (const Rational& step : {Rational(2), Rational(7, 3)}) {
      std::vector<Outcome> outcomes = {routed(sum, step)};
      for (const Side side : {Side::nearest, Side::contain, Side::contained})
        outcomes.push_back(rounded_to(sum, boundary, step, side));
      for (Outcome& one : outcomes) {
        for (const auto& [what, count] : one.counts) all.counts[what] += count;
        if (one.kind == Outcome::Kind::fails) return all.fail(one.why, one.at);
      }
    }
  }
  return all;
}

const Registered registered({
    .id = "law-rounding",
    .sources =
        {{"grid", 8, 4}, {"holes", 4, 2}, {"components", 3, 2}, {"tight", 4, 2}, {"star", 8, 1}},
    .promises = {{"holes", 10}, {"reflex vertices", 10}, {"several components", 10}},
    .kills = {"contained-covers-what-just-fits", "pixels-have-no-sides",
              "rounding-grows-by-half-as-much", "rounding-grows-by-twice-as-much"},
    .cases = 60,
    .check = check,
});

}  // namespace

}  // namespace oplus
