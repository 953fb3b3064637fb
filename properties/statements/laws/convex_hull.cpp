// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/laws/convex_hull.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/mpq_class.h>

#include <iterator>

namespace oplus {

Chain convex_hull(const std::vector<Point>& points) {
  using Kernel = CGAL::Simple_cartesian<Rational>;
  std::vector<Kernel::Point_2> all, hull;
  for (const Point& p : points) all.emplace_back(p.x, p.y);
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(hull));
  Chain chain;
  for (const Kernel::Point_2& p : hull) chain.push_back({p.x(), p.y()});
  return chain;
}

bool is_convex(const Region& region) {
  std::vector<Point> vertices;
  for (const Chain& chain : chains(region))
    vertices.insert(vertices.end(), chain.begin(), chain.end());
  return area(polygon(convex_hull(vertices))) == area(region);
}

}  // namespace oplus
