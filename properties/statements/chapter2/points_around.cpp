// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter2/points_around.hpp"

#include <algorithm>

namespace oplus {

namespace {

/// A point on the ray from x before it meets a segment.
Point before_first_hit(const Point& x, const Vector& along, const std::vector<Segment>& segments) {
  const Segment step{x, x + along};
  std::vector<Point> hits;
  for (const Segment& s : segments) {
    for (const Point& hit : intersection(step, s)) hits.push_back(hit);
  }
  const Segment first = cut(step, hits).front();
  return midpoint(first.source, first.target);
}

}  // namespace

std::vector<Point> points_to_the_left(const Point& x, const Vector& along,
                                      const std::vector<Segment>& segments) {
  std::vector<Vector> rays{along, -along};
  for (const Segment& s : segments) {
    if (!lies_on(x, s)) continue;
    for (const Vector& ray : {s.source - x, s.target - x})
      if (sign(cross(along, ray)) > 0) rays.push_back(ray);
  }
  const auto turns_left = [](const Vector& u, const Vector& v) { return sign(cross(u, v)) > 0; };
  const auto is_same = [](const Vector& u, const Vector& v) { return sign(cross(u, v)) == 0; };
  // From along to -along, which are the ends of this order but parallel.
  std::sort(rays.begin() + 2, rays.end(), turns_left);
  rays.erase(std::unique(rays.begin() + 2, rays.end(), is_same), rays.end());
  std::rotate(rays.begin() + 1, rays.begin() + 2, rays.end());

  std::vector<Point> points;
  for (std::size_t i = 1; i < rays.size(); ++i) {
    const bool is_half_plane = rays.size() == 2;
    const Vector between = is_half_plane ? Vector{-along.y, along.x} : rays[i - 1] + rays[i];
    points.push_back(before_first_hit(x, between, segments));
    if (i + 1 < rays.size()) points.push_back(before_first_hit(x, rays[i], segments));
  }
  return points;
}

std::vector<Point> points_around(const Point& x, const std::vector<Segment>& segments) {
  const Vector east{1, 0};
  std::vector<Point> points = points_to_the_left(x, east, segments);
  for (const Point& below : points_to_the_left(x, -east, segments)) points.push_back(below);
  for (const Vector& ray : {east, -east}) points.push_back(before_first_hit(x, ray, segments));
  return points;
}

}  // namespace oplus
