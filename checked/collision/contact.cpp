// SPDX-License-Identifier: MIT
#include "checked/collision/contact.hpp"

#include <algorithm>

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

namespace {

Vector exact_direction(const BoundaryRay& ray) {
  return ray.is_ahead ? direction_of(*ray.edge) : -direction_of(*ray.edge);
}

std::optional<bool> is_in_lower_half(const IntervalPoint& v) {
  const std::optional<int> y = sign(v.y);
  if (!y) return std::nullopt;
  if (*y != 0) return *y < 0;
  const std::optional<int> x = sign(v.x);
  if (!x) return std::nullopt;
  return *x < 0;
}

int compare_angle(const BoundaryRay& a, const BoundaryRay& b) {
  const std::optional<bool> of_a = is_in_lower_half(a.near), of_b = is_in_lower_half(b.near);
  if (of_a && of_b) {
    if (*of_a != *of_b) return *of_a ? 1 : -1;
    if (const std::optional<int> turn = sign_of_cross(a.near, b.near)) return -*turn;
  }
  return compare_angle(exact_direction(a), exact_direction(b));
}

}  // namespace

bool interiors_meet_around(std::span<BoundaryRay> rays) {
  std::sort(rays.begin(), rays.end(),
            [](const BoundaryRay& a, const BoundaryRay& b) { return compare_angle(a, b) < 0; });
  std::vector<InteriorSides> in_order;
  in_order.reserve(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (i == 0 || compare_angle(rays[i - 1], rays[i]) != 0) in_order.emplace_back();
    in_order.back()[static_cast<std::size_t>(rays[i].of)] = rays[i].is_ahead;
  }
  return is_sector_inside_both(in_order);
}

}  // namespace oplus
