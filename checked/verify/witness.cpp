// SPDX-License-Identifier: MIT
#include "checked/verify/witness.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <utility>

#include "reference/arithmetic/floor_of.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/ray.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/definitions/verdicts_differ.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Rounded down to a multiple of 1/scale.
Rational rounded(const Rational& value, const mpz_class& scale) {
  return Rational(floor_of(Rational(value * Rational(scale)))) / Rational(scale);
}

/// Of the face of all the segments.
Point point_left_of(const Segment& segment, const std::vector<Segment>& edges) {
  std::vector<Point> ends;
  for (const Segment& e : edges)
    for (const Point* end : {&e.source, &e.target})
      if (lies_on(*end, segment)) ends.push_back(*end);
  // Between two of them, so that nothing starts where the way into the face does.
  const Segment piece = cut(segment, std::move(ends))[0];
  const Vector along = direction_of(piece);
  return point_beside(midpoint(piece.source, piece.target), {-along.y, along.x}, edges);
}

/// Of the way from the middle of an edge: not at a right angle, so that the point is hardly ever where something
/// else is that is regular.
double slope(int attempt) { return 0.125 + 0.171875 * attempt; }

/// point_near, where doubles are exact enough. Of all segments, only the edge meets a circle around its
/// middle, and cuts it in two. So a point in the circle is in the face on its side of the edge.
std::optional<Point> point_near_in_doubles(const SegmentTree& edges, std::size_t edge, bool left,
                                           int attempt, double most_room) {
  const IntervalSegment& e = edges.certified(edge);
  const auto exactly = [](double x) { return Interval{x, x}; };
  const IntervalPoint middle{exactly(e.source.x.low / 2 + e.target.x.low / 2),
                             exactly(e.source.y.low / 2 + e.target.y.low / 2)};
  const Box box = box_of(middle);
  double room = most_room * most_room * (1 - 0x1p-48);  // squared
  edges.look_for(
      room, [&](const Box& b) { return squared_gap(b, box); },
      [&](std::size_t i) {
        if (i != edge) room = std::min(room, squared_distance(middle, edges.certified(i)).low);
        return room;
      });
  if (!(squared_distance(middle, e).high < room / 16)) return std::nullopt;
  const double along_x = e.target.x.low - e.source.x.low;
  const double along_y = e.target.y.low - e.source.y.low;
  const double step = std::sqrt(room / (along_x * along_x + along_y * along_y)) / (left ? 4 : -4);
  if (!std::isnormal(step)) return std::nullopt;
  const int digits = std::ilogb(room) / 2 - 6 - 9 * attempt;
  const auto at = [&](double from, double by) {
    return exactly(std::ldexp(std::nearbyint(std::ldexp(from + by, -digits)), digits));
  };
  const IntervalPoint x{at(middle.x.low, step * (along_x * slope(attempt) - along_y)),
                        at(middle.y.low, step * (along_y * slope(attempt) + along_x))};
  const IntervalPoint way = x - middle;
  if (!((way.x * way.x + way.y * way.y).high < room / 9) ||
      orientation(e.source, e.target, x) != std::optional(left ? 1 : -1))
    return std::nullopt;
  return Point{Rational(x.x.low), Rational(x.y.low)};
}

}  // namespace

Point point_left_of(const Segment& segment, const std::vector<Segment>& edges,
                    const std::vector<Segment>& avoided) {
  Point inside = point_left_of(segment, edges);
  if (!lies_on_one(inside, avoided)) return inside;
  std::vector<Segment> all = edges;
  all.insert(all.end(), avoided.begin(), avoided.end());
  return point_left_of(segment, all);
}

Point point_of_face(const std::vector<Segment>& boundary, const std::vector<Segment>& avoided) {
  const Point inside = point_left_of(boundary[0], boundary, avoided);
  const ExactBox box = box_around(boundary);
  const auto may_be_inside = [&](const Point& p) {
    return box.low.x < p.x && p.x < box.high.x && box.low.y < p.y && p.y < box.high.y;
  };
  mpz_class scale = 1;
  for (int digits = 0; digits <= 9; ++digits, scale *= 10) {
    const Rational x = rounded(inside.x, scale);
    const Rational y = rounded(inside.y, scale);
    const Rational step = Rational(1) / Rational(scale);
    for (const Point& p : {Point{x, y}, {x + step, y}, {x, y + step}, {x + step, y + step}}) {
      if (may_be_inside(p) && !lies_on_one(p, boundary) && winding_number(p, boundary) == 1 &&
          !lies_on_one(p, avoided))
        return p;
    }
  }
  return inside;
}

Point point_near(const SegmentTree& edges, std::size_t edge, bool left, int attempt,
                 double most_room) {
  if (std::optional<Point> point = point_near_in_doubles(edges, edge, left, attempt, most_room))
    return *point;
  // Between two places where others touch it.
  const Segment piece = cut_where_met(edges[edge], edges)[0];
  const Point middle = midpoint(piece.source, piece.target);
  Rational room = squared_distance(middle, edges, -1, edge);
  if (most_room <= DBL_MAX)
    room = std::min(room, Rational(Rational(most_room) * Rational(most_room)));
  if (sign(room) == 0) throw VerdictsDiffer("edges of the sum overlap at " + to_string(middle));
  const Vector along = direction_of(piece);
  const Vector beside = left ? Vector{-along.y, along.x} : Vector{along.y, -along.x};
  Vector way = beside + Rational(slope(attempt)) * along;
  while (4 * squared_length(way) > room) way = Rational(1, 2) * way;
  // Rounded by at most a fifth of the way.
  mpz_class scale = 1;
  while (squared_length(way) * scale * scale < 64) scale *= 2;
  const Point x = middle + way;
  return {rounded(x.x, scale), rounded(x.y, scale)};
}

}  // namespace oplus
