// SPDX-License-Identifier: MIT
#include "checked/collision/contact.hpp"

#include <algorithm>

#include "reference/definitions/contract.hpp"

namespace oplus {

bool is_sector_inside_both(const std::vector<InteriorSides>& rays) {
  // The sector before the first ray is the one after the last: go around twice.
  std::array<bool, 2> inside{false, false};
  for (int turn = 0; turn < 2; ++turn) {
    for (const InteriorSides& ray : rays) {
      for (std::size_t of : {0U, 1U}) inside[of] = ray[of].value_or(inside[of]);
      if (turn == 1 && inside[0] && inside[1]) return true;
    }
  }
  return false;
}

void add_rays(const Segment& edge, Summand of, const Point& at, std::vector<BoundaryRay>& rays) {
  OPLUS_REQUIRES(lies_on(at, edge), "Section 5.1.1");
  // The interior is to the left of the edge: counterclockwise of the ray ahead, clockwise of the
  // ray that leads back.
  if (at != edge.target) rays.push_back({{direction_of(edge), of}, true});
  if (at != edge.source) rays.push_back({{-direction_of(edge), of}, false});
}

bool interiors_meet_around(std::vector<BoundaryRay> rays) {
  std::sort(rays.begin(), rays.end(), [](const BoundaryRay& a, const BoundaryRay& b) {
    return compare_angle(a.direction.vector, b.direction.vector) < 0;
  });
  std::vector<InteriorSides> in_order;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (i == 0 || !same_direction(rays[i - 1].direction.vector, rays[i].direction.vector))
      in_order.emplace_back();
    in_order.back()[static_cast<std::size_t>(rays[i].direction.of)] =
        rays[i].interior_is_counterclockwise;
  }
  return is_sector_inside_both(in_order);
}

}  // namespace oplus
