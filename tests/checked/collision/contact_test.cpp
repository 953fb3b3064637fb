// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

const Vector east{1, 0};
const Vector west{-1, 0};

TEST(Contact, edge_that_passes_through_has_two_rays_its_interior_to_the_left) {
  std::vector<BoundaryRay> rays;
  add_rays({{0, 0}, {4, 0}}, Summand::Q, {1, 0}, rays);
  ASSERT_EQ(rays.size(), 2u);
  EXPECT_TRUE(same_direction(rays[0].direction.vector, east));
  EXPECT_TRUE(rays[0].interior_is_counterclockwise);
  EXPECT_TRUE(same_direction(rays[1].direction.vector, west));
  EXPECT_FALSE(rays[1].interior_is_counterclockwise);
  for (const BoundaryRay& ray : rays) EXPECT_EQ(ray.direction.of, Summand::Q);
}

TEST(Contact, edge_that_ends_there_has_one_ray) {
  std::vector<BoundaryRay> rays;
  add_rays({{0, 0}, {4, 0}}, Summand::P, {0, 0}, rays);
  add_rays({{0, 4}, {0, 0}}, Summand::P, {0, 0}, rays);
  ASSERT_EQ(rays.size(), 2u) << "appended";
  EXPECT_TRUE(same_direction(rays[0].direction.vector, {1, 0}));
  EXPECT_TRUE(rays[0].interior_is_counterclockwise);
  EXPECT_TRUE(same_direction(rays[1].direction.vector, {0, 1}));
  EXPECT_FALSE(rays[1].interior_is_counterclockwise);
}

constexpr std::optional<bool> none;

TEST(Contact, sector_between_rays_in_order_is_inside_both) {
  EXPECT_TRUE(is_sector_inside_both({{true, none}, {none, true}, {false, none}, {none, false}}));
  EXPECT_FALSE(is_sector_inside_both({{true, none}, {false, none}, {none, true}, {none, false}}));
  EXPECT_TRUE(is_sector_inside_both({{none, false}, {false, none}, {true, none}, {none, true}}))
      << "only the sector after the last ray";
}

TEST(Contact, sector_beside_a_ray_of_both_summands_is_inside_both_iff_directions_are_equal) {
  EXPECT_TRUE(is_sector_inside_both({{true, true}, {false, none}, {none, false}}));
  EXPECT_FALSE(is_sector_inside_both({{true, false}, {false, none}, {none, true}}));
  EXPECT_TRUE(is_sector_inside_both({{true, true}, {false, false}})) << "equal sectors";
  EXPECT_FALSE(is_sector_inside_both({{true, false}, {false, true}})) << "the plane filled";
}

TEST(Contact, no_sector_is_inside_a_summand_without_rays) {
  EXPECT_FALSE(is_sector_inside_both({}));
  EXPECT_FALSE(is_sector_inside_both({{true, none}, {false, none}}));
}

/// Eight directions around a point cut its neighbourhood into eight sectors, sector i before
/// direction i + 1. Bit i of a mask: sector i is inside.
const std::array<Vector, 8> directions{
    {{3, 0}, {1, 1}, {0, 2}, {-1, 1}, {-1, 0}, {-2, -2}, {0, -1}, {1, -1}}};

bool has(unsigned mask, std::size_t sector) { return (mask >> sector & 1U) != 0; }

void add_boundary(unsigned mask, Summand of, std::vector<BoundaryRay>& rays) {
  for (std::size_t i = 0; i < 8; ++i) {
    const bool after = has(mask, i);
    const bool before = has(mask, (i + 7) % 8);
    if (after != before) rays.push_back({{directions[i], of}, after});
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

TEST(Contact, interiors_meet_around_does_not_depend_on_the_order_of_the_rays) {
  for (const unsigned q : {0b00000110U, 0b00010100U, 0b11100001U, 0b01111000U}) {
    std::vector<BoundaryRay> rays;
    add_boundary(q, Summand::Q, rays);
    add_boundary(0b00011000U, Summand::P, rays);
    const std::vector<BoundaryRay> backwards(rays.rbegin(), rays.rend());
    EXPECT_EQ(interiors_meet_around(backwards), (q & 0b00011000U) != 0) << q;
  }
}

}  // namespace
}  // namespace oplus
