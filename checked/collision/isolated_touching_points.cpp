// SPDX-License-Identifier: MIT
#include "checked/collision/isolated_touching_points.hpp"

#include "reference/chains/region_of.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

std::vector<Point> isolated_touching_points(
    const Region& p, const Region& q, const std::function<bool(const Point&)>& interiors_meet_at,
    const MinkowskiSum& found) {
  const std::vector<Point> of_p = touching_points(p);
  const std::vector<Point> of_q = of_p.empty() ? of_p : touching_points(q);
  std::vector<Point> isolated;
  if (of_q.empty() ||
      OPLUS_MUTANT("touching-points-are-not-tested",
                   "isolated vertices are looked for on the reduced convolution only"))
    return isolated;
  const Region closed = region_of(found);
  for (const Point& a : of_p) {
    for (const Point& b : of_q) {
      const Point x = a + b;
      if (!lies_on_one(x, found.dangling_edges) && locate(x, closed) == Location::inside &&
          !interiors_meet_at(x))
        isolated.push_back(x);
    }
  }
  return isolated;
}

}  // namespace oplus
