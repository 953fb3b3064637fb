// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/rich_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "reference/chains/validity.hpp"

namespace oplus {
namespace {

bool touch(const Chain& a, const Chain& b) {
  for (const Segment& s : edges(a))
    for (const Segment& t : edges(b))
      if (!intersection(s, t).empty()) return true;
  return false;
}

/// Whether the component is in a hole of another one.
bool is_island(const Component& island, const Region& region) {
  const Point inside_or_on = midpoint(island.outer[0], island.outer[1]);
  return std::any_of(region.components.begin(), region.components.end(), [&](const Component& c) {
    return c != island && locate(inside_or_on, polygon(c.outer)) == Location::inside;
  });
}

TEST(HoledRegion, has_one_component_with_holes_that_often_touch) {
  Random random(1);
  int several = 0;
  int touching_outer = 0;
  int touching_hole = 0;
  for (int i = 0; i < 100; ++i) {
    const Region region = holed_region(random, 6);
    ASSERT_EQ(find_defect(region), std::nullopt);
    ASSERT_EQ(region.components.size(), 1u);
    const Component& component = region.components[0];
    ASSERT_FALSE(component.holes.empty());
    several += component.holes.size() > 1 ? 1 : 0;
    bool outer = false;
    bool hole = false;
    for (std::size_t h = 0; h < component.holes.size(); ++h) {
      outer = outer || touch(component.holes[h], component.outer);
      for (std::size_t g = 0; g < h; ++g)
        hole = hole || touch(component.holes[h], component.holes[g]);
    }
    touching_outer += outer ? 1 : 0;
    touching_hole += hole ? 1 : 0;
  }
  EXPECT_GE(several, 10);
  EXPECT_GE(touching_outer, 30);
  EXPECT_LE(touching_outer, 95);
  EXPECT_GE(touching_hole, 5);
}

TEST(ScatteredRegion, has_components_apart_touching_and_nested) {
  Random random(1);
  int touching = 0;
  int apart = 0;
  int islands = 0;
  int holed = 0;
  for (int i = 0; i < 200; ++i) {
    const Region region = scattered_region(random, 5);
    ASSERT_EQ(find_defect(region), std::nullopt);
    ASSERT_GE(region.components.size(), 2u);
    ASSERT_LE(region.components.size(), 4u);
    bool some_touch = false;
    for (std::size_t a = 0; a < region.components.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        some_touch = some_touch || touch(region.components[a].outer, region.components[b].outer);
    (some_touch ? touching : apart) += 1;
    holed += has_hole(region) ? 1 : 0;
    islands += std::any_of(region.components.begin(), region.components.end(),
                           [&](const Component& c) { return is_island(c, region); })
                   ? 1
                   : 0;
  }
  EXPECT_GE(touching, 40);
  EXPECT_GE(apart, 40);
  EXPECT_GE(islands, 10);
  EXPECT_GE(holed, 40);
}

TEST(PlainRegion, is_one_chain) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Region region = plain_region(random, 7);
    EXPECT_EQ(find_defect(region), std::nullopt);
    EXPECT_EQ(chains(region).size(), 1u);
    EXPECT_LE(vertex_count(region), 7u);
  }
}

}  // namespace
}  // namespace oplus
