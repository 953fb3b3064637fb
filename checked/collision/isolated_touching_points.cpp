// SPDX-License-Identifier: MIT
#include "checked/collision/isolated_touching_points.hpp"

#include "reference/chains/touching_points.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

std::vector<Point> isolated_touching_points(
    const Region& p, const Region& q, const std::function<bool(const Point&)>& interiors_meet_at,
    const std::function<PlanarSet()>& found) {
  const std::vector<Point> of_p = touching_points(p);
  const std::vector<Point> of_q = of_p.empty() ? of_p : touching_points(q);
  std::vector<Point> sums;
  if (of_q.empty() ||
      OPLUS_MUTANT("touching-points-are-not-tested",
                   "isolated vertices are looked for on the reduced convolution only"))
    return sums;
  for (const Point& a : of_p)
    for (const Point& b : of_q) sums.push_back(a + b);
  sums = sorted_without_copies(std::move(sums));
  std::erase_if(sums, interiors_meet_at);
  if (sums.empty()) return sums;
  // A sum of points of both is in the closure of the open sum: so, if it is not in the open sum, it is
  // on an edge of its boundary or isolated.
  const std::vector<Segment> boundary = edges(found());
  std::erase_if(sums, [&](const Point& x) { return lies_on_one(x, boundary); });
  return sums;
}

}  // namespace oplus
