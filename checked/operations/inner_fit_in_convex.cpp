// SPDX-License-Identifier: MIT
#include "checked/operations/inner_fit_in_convex.hpp"

#include <algorithm>
#include <utility>

#include "reference/definitions/mutant.hpp"
#include "reference/definitions/region.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

namespace {

/// The points below all others, from left to right.
std::vector<Point> lower_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  std::vector<Point> hull;
  for (Point& p : points) {
    if (!hull.empty() && hull.back().x == p.x) continue;
    while (hull.size() > 1 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0)
      hull.pop_back();
    hull.push_back(std::move(p));
  }
  return hull;
}

/// How low q may be moved so that it stays above the lower edges of p: the highest of lines, which are given as
/// the lower hull of points, the line y = a x - b by (a, b). So slopes of the hull are where two lines meet.
using Bound = std::vector<Point>;

Bound lower_bound(const Chain& p, const std::vector<Point>& q) {
  const std::vector<Point> hull = lower_hull(q);
  auto lowest = hull.begin();
  std::vector<Point> lines;
  // Edges of a convex chain are in the order of their slopes.
  const auto first = static_cast<std::size_t>(std::min_element(p.begin(), p.end()) - p.begin());
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Point& from = p[(first + k) % p.size()];
    const Vector along = p[(first + k + 1) % p.size()] - from;
    if (along.x <= 0) break;
    while (lowest + 1 != hull.end() && cross(along, *(lowest + 1) - *lowest) <= 0 &&
           !OPLUS_MUTANT("inner-fits-look-at-one-vertex",
                         "where P is convex, Q fits in it where its leftmost vertex does"))
      ++lowest;
    const Vector at = from - *lowest;
    const Rational slope = along.y / along.x;
    lines.push_back({slope, slope * at.x - at.y});
  }
  return lower_hull(std::move(lines));
}

Rational slope(const Point& a, const Point& b) { return (b.y - a.y) / (b.x - a.x); }

/// The corners of a bound from one x to another.
std::vector<Point> corners(const Bound& bound, const Rational& from, const Rational& to) {
  auto line = bound.begin();
  const auto ends_before = [&](const Rational& x) {
    return line + 1 != bound.end() && slope(*line, *(line + 1)) < x;
  };
  const auto at = [&](const Rational& x) { return Point{x, line->x * x - line->y}; };
  while (ends_before(from)) ++line;
  std::vector<Point> result = {at(from)};
  for (; ends_before(to); ++line)
    if (Rational x = slope(*line, *(line + 1)); x > from) result.push_back(at(x));
  if (from < to) result.push_back(at(to));
  return result;
}

/// Upside down, the chain counterclockwise.
std::vector<Point> mirrored(std::vector<Point> points) {
  std::reverse(points.begin(), points.end());
  for (Point& p : points) p.y = -p.y;
  return points;
}

}  // namespace

std::optional<PlanarSet> inner_fit_in_convex(const Chain& p, const std::vector<Point>& q) {
  if (q.empty() || !is_convex(p)) return std::nullopt;
  const auto [first_p, last_p] = std::minmax_element(p.begin(), p.end());
  const auto [first_q, last_q] = std::minmax_element(q.begin(), q.end());
  Rational low = first_p->x - first_q->x, high = last_p->x - last_q->x;
  const Bound below = lower_bound(p, q), above = lower_bound(mirrored(p), mirrored(q));
  // There is room between two bounds, one upside down, where the sum of any two of their lines is not positive: of
  // these, such as meet both bounds at one x are enough.
  for (std::size_t i = 0, j = 0; i < below.size() && j < above.size();) {
    const Point line = below[i] + above[j];
    if (line.x > 0) high = std::min(high, Rational(line.y / line.x));
    if (line.x < 0) low = std::max(low, Rational(line.y / line.x));
    if (low > high || (line.x == 0 && line.y < 0)) return PlanarSet{};
    const bool next_below =
        j + 1 == above.size() ||
        (i + 1 < below.size() && cross(below[i + 1] - below[i], above[j + 1] - above[j]) >= 0);
    ++(next_below ? i : j);
  }
  PlanarSet fit;
  Chain chain = corners(below, low, high);
  for (const Point& corner : mirrored(corners(above, low, high)))
    if (corner != chain.back() && corner != chain.front()) chain.push_back(corner);
  if (chain.size() == 1)
    fit.isolated_vertices = std::move(chain);
  else if (chain.size() == 2)
    fit.dangling_edges.push_back({chain[0], chain[1]});
  else
    fit.outer.push_back(std::move(chain));
  return fit;
}

}  // namespace oplus
