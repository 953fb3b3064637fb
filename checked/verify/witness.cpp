// SPDX-License-Identifier: MIT
#include "checked/verify/witness.hpp"

#include <algorithm>
#include <utility>

#include "reference/definitions/ray.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

/// Rounded down to a multiple of 1/scale.
Rational rounded(const Rational& value, const mpz_class& scale) {
  const Rational scaled = value * Rational(scale);
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return Rational(floor) / Rational(scale);
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
  Point low = inside, high = inside;
  for (const Segment& e : boundary) {
    low = {std::min(low.x, e.source.x), std::min(low.y, e.source.y)};
    high = {std::max(high.x, e.source.x), std::max(high.y, e.source.y)};
  }
  const auto may_be_inside = [&](const Point& p) {
    return low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y;
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

Point point_near(const SegmentTree& edges, std::size_t edge, bool left) {
  // Between two places where others touch it.
  const Segment piece = cut_where_met(edges[edge], edges)[0];
  const Point middle = midpoint(piece.source, piece.target);
  const Rational room = squared_distance(middle, edges, -1, edge);
  // Not at a right angle, so that it is hardly ever where something else is that is regular.
  const Vector along = direction_of(piece);
  const Vector beside = left ? Vector{-along.y, along.x} : Vector{along.y, -along.x};
  Vector way = beside + Rational(1, 8) * along;
  while (4 * squared_length(way) > room) way = Rational(1, 2) * way;
  // Rounded by at most a fifth of the way.
  mpz_class scale = 1;
  while (squared_length(way) * scale * scale < 64) scale *= 2;
  const Point x = middle + way;
  return {rounded(x.x, scale), rounded(x.y, scale)};
}

}  // namespace oplus
