// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/contact.hpp"

#include <gtest/gtest.h>

#include <array>

namespace oplus {
namespace {

/// Eight directions around a point cut its neighbourhood into eight sectors, sector i before
/// direction i + 1. Bit i of a mask: sector i is inside.
const std::array<Vector, 8> directions{
    {{3, 0}, {1, 1}, {0, 2}, {-1, 1}, {-1, 0}, {-2, -2}, {0, -1}, {1, -1}}};

bool has(unsigned mask, std::size_t sector) { return (mask >> sector & 1U) != 0; }

void add_boundary(unsigned mask, Summand of, std::vector<BoundaryRay>& rays) {
  for (std::size_t i = 0; i < 8; ++i) {
    const bool after = has(mask, i);
    const bool before = has(mask, (i + 7) % 8);
    if (after == before) continue;
    static const std::array<std::vector<Segment>, 2> edges = [] {
      std::array<std::vector<Segment>, 2> all;
      for (const Vector& direction : directions) {
        all[0].push_back({direction, {}});
        all[1].push_back({{}, direction});
      }
      return all;
    }();
    const Segment& edge = edges[after ? 1 : 0][i];
    rays.push_back(ray_along(edge, interval(edge), after, of));
  }
}

TEST(Contact, interiors_meet_around_where_a_sector_is_inside_both) {
  // All ways in which chains can pass a point, but for those of no boundary at all.
  for (unsigned p = 1; p < 255; ++p) {
    for (unsigned q = 1; q < 255; ++q) {
      std::vector<BoundaryRay> rays;
      add_boundary(p, Summand::P, rays);
      add_boundary(q, Summand::Q, rays);
      ASSERT_EQ(interiors_meet_around(rays), (p & q) != 0) << p << ' ' << q;
    }
  }
}

}  // namespace
}  // namespace oplus
