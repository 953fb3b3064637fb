// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/laws/convex_hull.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/mpq_class.h>

#include <iterator>

namespace oplus {

Chain convex_hull(const std::vector<Chain>& chains) {
  using Kernel = CGAL::Simple_cartesian<Rational>;
  std::vector<Kernel::Point_2> all, hull;
  for (const Chain& chain : chains)
    for (const Point& p : chain) all.emplace_back(p.x, p.y);
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(hull));
  Chain corners;
  for (const Kernel::Point_2& p : hull) corners.push_back({p.x(), p.y()});
  return corners;
}

bool is_convex(const Region& region) {
  return area(polygon(convex_hull(chains(region)))) == area(region);
}

}  // namespace oplus
