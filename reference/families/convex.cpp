// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "reference/families/circle_point.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

/// The extreme points, counterclockwise from the lexicographically smallest.
Chain convex_hull(Chain points) {
  std::sort(points.begin(), points.end());
  Chain hull;
  // From left to right below, then back above.
  for (int side = 0; side < 2; ++side, std::reverse(points.begin(), points.end())) {
    const std::size_t first = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= first + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
  }
  return hull;
}

}  // namespace

Region convex_polygon(Random& random, std::size_t n) {
  const mpz_class enough = mpz_class(static_cast<unsigned long>(n)) * static_cast<unsigned long>(n);
  const mpz_class drawn = uniform(random, 100'000, 1'000'000);
  const mpz_class radius = std::max(drawn, enough);
  // Rounding makes a few points not extreme; each is replaced by a new one.
  Chain hull;
  while (hull.size() < n) {
    for (std::size_t missing = n - hull.size(); missing > 0; --missing)
      hull.push_back(circle_point(random, radius));
    hull = convex_hull(std::move(hull));
  }
  return polygon(hull);
}

Region convex_grid_polygon(Random& random, std::size_t points, int side) {
  Chain hull;
  while (hull.size() < 3) {
    Chain drawn;
    for (std::size_t i = 0; i < points; ++i)
      drawn.push_back({uniform(random, 0, side - 1), uniform(random, 0, side - 1)});
    hull = convex_hull(std::move(drawn));
  }
  return polygon(hull);
}

}  // namespace oplus
