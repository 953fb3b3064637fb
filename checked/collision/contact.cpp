// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/contact.hpp"

#include <algorithm>
#include <array>

#include "reference/definitions/contract.hpp"

namespace oplus {

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
  // The sector before the first ray is the one after the last: go around twice.
  std::array<bool, 2> inside{false, false};
  for (int turn = 0; turn < 2; ++turn) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      inside[static_cast<std::size_t>(rays[i].direction.of)] = rays[i].interior_is_counterclockwise;
      const bool sector_follows =
          i + 1 == rays.size() ||
          !same_direction(rays[i].direction.vector, rays[i + 1].direction.vector);
      if (turn == 1 && sector_follows && inside[0] && inside[1]) return true;
    }
  }
  return false;
}

}  // namespace oplus
