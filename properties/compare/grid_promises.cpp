// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/grid_promises.hpp"

#include <algorithm>

#include "reference/definitions/cells.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

bool is_multiple(const Rational& value, const Rational& step) {
  return Rational(value / step).get_den() == 1;
}

/// Whether a point is at most that far from some segment, in x and in y.
bool is_near_one(const Point& x, const std::vector<Segment>& segments, const Rational& bound) {
  const Chain square = {x + Vector{-bound, -bound}, x + Vector{bound, -bound},
                        x + Vector{bound, bound}, x + Vector{-bound, bound}};
  const auto is_in_square = [&](const Point& p) {
    return abs(p.x - x.x) <= bound && abs(p.y - x.y) <= bound;
  };
  return std::ranges::any_of(segments, [&](const Segment& s) {
    if (is_in_square(s.source) || is_in_square(s.target)) return true;
    // A segment of no square has no inner point.
    return bound > 0 ? std::ranges::any_of(
                           edges(square),
                           [&](const Segment& side) { return !intersection(s, side).empty(); })
                     : lies_on(x, s);
  });
}

/// A point of each cell of the arrangement.
std::vector<Point> points_of_cells(const std::vector<Segment>& segments) {
  const Cells arrangement = cells(segments);
  std::vector<Point> points = arrangement.vertices;
  for (const Cells::Edge& e : arrangement.edges)
    points.push_back(midpoint(e.segment.source, e.segment.target));
  for (const std::vector<Segment>& face : arrangement.faces)
    points.push_back(face.empty() ? Point{} : point_inside(face));
  return points;
}

}  // namespace

std::optional<Failure> broken_promise(const PlanarSet& set, const RoundedSet& result,
                                      const Rational& step, Side side) {
  for (const Segment& e : edges(result.set))
    if (!is_multiple(e.source.x, step) || !is_multiple(e.source.y, step))
      return Failure{"off the grid", "the vertex " + to_string(e.source), e.source};
  const std::vector<Segment> boundary = edges(set);
  std::vector<Segment> both = edges(result.set);
  both.insert(both.end(), boundary.begin(), boundary.end());
  for (const Point& x : points_of_cells(both)) {
    const Location of_result = locate(x, result.set);
    const bool in_set = locate(x, set) != Location::outside;
    const bool in_result = of_result != Location::outside;
    const auto broken = [&](const std::string& kind) {
      return Failure{kind,
                     to_string(x) + " is " + (in_set ? "in" : "outside") + " the set, and " +
                         (in_result ? "in" : "outside") + " what it is rounded to",
                     x};
    };
    if ((side == Side::contain && in_set && !in_result) ||
        (side == Side::contained && in_result && !in_set))
      return broken("side not kept");
    if ((in_set != in_result || of_result == Location::boundary) &&
        !is_near_one(x, boundary, result.bound))
      return broken("beyond the bound");
  }
  return std::nullopt;
}

}  // namespace oplus
