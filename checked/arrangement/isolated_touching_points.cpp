// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/isolated_touching_points.hpp"

#include <algorithm>

#include "reference/definitions/mutant.hpp"

namespace oplus {

std::vector<Point> isolated_touching_points(
    const Region& p, const Region& q, const std::function<bool(const Point&)>& interiors_meet_at,
    const MinkowskiSum& found) {
  const std::vector<Point> of_p = touching_points(p);
  const std::vector<Point> of_q = of_p.empty() ? of_p : touching_points(q);
  std::vector<Point> isolated;
  if (of_q.empty() || OPLUS_MUTANT("touching-points-are-not-tested")) return isolated;
  const Region closed = region_of(found);
  for (const Point& a : of_p) {
    for (const Point& b : of_q) {
      const Point x = a + b;
      const bool on_dangling_edge =
          std::any_of(found.dangling_edges.begin(), found.dangling_edges.end(),
                      [&](const Segment& e) { return lies_on(x, e); });
      if (!on_dangling_edge && locate(x, closed) == Location::inside && !interiors_meet_at(x))
        isolated.push_back(x);
    }
  }
  return isolated;
}

}  // namespace oplus
