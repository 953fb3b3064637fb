// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/places/points_beside.hpp"

#include <optional>
#include <set>
#include <utility>

#include "reference/definitions/cut_at_intersections.hpp"

namespace oplus {

namespace {

/// The positive t at which the ray x + t·along meets s; the smaller one where s is on the ray.
std::optional<Rational> hit(const Point& x, const Vector& along, const Segment& s) {
  const Vector v = direction_of(s);
  const Vector to_source = s.source - x;
  const Rational determinant = cross(along, v);
  if (sign(determinant) != 0) {
    const Rational t = cross(to_source, v) / determinant;
    const Rational u = cross(to_source, along) / determinant;
    return t > 0 && u >= 0 && u <= 1 ? std::optional(t) : std::nullopt;
  }
  if (sign(cross(to_source, along)) != 0) return std::nullopt;
  const Rational length = dot(along, along);
  const Rational t1 = dot(to_source, along) / length;
  const Rational t2 = dot(s.target - x, along) / length;
  const Rational& nearest = t1 < t2 ? t1 : t2;
  return nearest > 0 ? std::optional(nearest) : std::nullopt;
}

}  // namespace

Point point_beside(const Point& x, const Vector& along, const std::vector<Segment>& segments) {
  Rational nearest = 2;
  for (const Segment& s : segments) {
    const std::optional<Rational> t = hit(x, along, s);
    if (t && *t < nearest) nearest = *t;
  }
  return x + Rational(nearest / 2) * along;
}

std::vector<Point> points_beside(const std::vector<Segment>& segments) {
  std::set<Segment> pieces;
  for (const std::vector<Segment>& of_segment : cut_at_intersections(segments)) {
    for (const Segment& piece : of_segment)
      pieces.insert(piece.target < piece.source ? reversed(piece) : piece);
  }
  std::vector<Point> points;
  points.reserve(2 * pieces.size());
  for (const Segment& piece : pieces) {
    const Point middle = midpoint(piece.source, piece.target);
    const Vector along = direction_of(piece);
    const Vector normal{along.y, -along.x};
    points.push_back(point_beside(middle, normal, segments));
    points.push_back(point_beside(middle, -normal, segments));
  }
  return points;
}

}  // namespace oplus
