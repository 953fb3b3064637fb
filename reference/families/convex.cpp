// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <iterator>

#include "reference/families/circle_point.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

// Integers below 2^53 are exact as doubles, and so are this kernel's predicates on them.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The extreme points, counterclockwise from the lexicographically smallest.
/// Requires: integers below 2^53.
Chain convex_hull(const Chain& points) {
  std::vector<Kernel::Point_2> converted;
  converted.reserve(points.size());
  for (const Point& p : points) converted.emplace_back(p.x.get_d(), p.y.get_d());
  std::vector<Kernel::Point_2> extreme;
  CGAL::convex_hull_2(converted.begin(), converted.end(), std::back_inserter(extreme));
  Chain hull;
  hull.reserve(extreme.size());
  for (const Kernel::Point_2& p : extreme) hull.push_back({Rational(p.x()), Rational(p.y())});
  std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end()), hull.end());
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
    hull = convex_hull(hull);
  }
  return polygon(hull);
}

Region convex_grid_polygon(Random& random, std::size_t points, int side) {
  Chain hull;
  while (hull.size() < 3) {
    Chain drawn;
    for (std::size_t i = 0; i < points; ++i)
      drawn.push_back({uniform(random, 0, side - 1), uniform(random, 0, side - 1)});
    hull = convex_hull(drawn);
  }
  return polygon(hull);
}

}  // namespace oplus
