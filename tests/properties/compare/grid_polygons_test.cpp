// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/grid_polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"

namespace oplus {
namespace {

/// All C(9, 3) choices of points but the 8 lines, each counted once for each of its places.
TEST(GridPolygons, are_all_triangles_of_the_grid) {
  std::size_t placed = 0;
  for (const GridPolygon& triangle : grid_polygons(3, 3)) {
    int width = 0, height = 0;
    for (const LatticePoint& p : triangle) {
      width = std::max(width, p.x);
      height = std::max(height, p.y);
    }
    placed += static_cast<std::size_t>((3 - width) * (3 - height));
  }
  EXPECT_EQ(placed, 84U - 8U);
}

TEST(GridPolygons, of_two_by_two_points_are_four_triangles_and_a_square) {
  const std::vector<GridPolygon> all = grid_polygons(2, 4);
  EXPECT_EQ(std::ranges::count(all, 3U, &GridPolygon::size), 4);
  EXPECT_EQ(std::ranges::count(all, 4U, &GridPolygon::size), 1);
  EXPECT_EQ(all.size(), 5U);
}

TEST(GridPolygons, are_valid_distinct_and_closed_under_symmetries) {
  const std::vector<GridPolygon> all = grid_polygons(3, 4);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) EXPECT_NE(all[i], all[i + 1]);
  for (const GridPolygon& polygon : all) {
    EXPECT_EQ(find_defect(region_of(polygon)), std::nullopt);
    EXPECT_EQ(image(polygon, 0), polygon);
    for (std::size_t s = 0; s < square_symmetries; ++s)
      EXPECT_EQ(std::ranges::count(all, image(polygon, s)), 1);
  }
}

TEST(GridPolygons, may_have_a_vertex_inside_a_straight_line) {
  const GridPolygon straight = {{0, 0}, {1, 0}, {2, 0}, {0, 1}};
  EXPECT_EQ(std::ranges::count(grid_polygons(3, 4), straight), 1);
}

/// Burnside: the number of orbits is the mean number of pairs that a symmetry, with or without
/// exchange, leaves as they are.
TEST(PairOrbits, are_as_many_as_burnside_counts) {
  for (const auto& [side, most] : {std::pair(2, 4), {3, 3}, {3, 4}}) {
    const std::vector<GridPolygon> all = grid_polygons(side, static_cast<std::size_t>(most));
    std::size_t fixed = 0;
    for (std::size_t s = 0; s < square_symmetries; ++s) {
      std::size_t by_one = 0, by_twice = 0;
      for (const GridPolygon& polygon : all) {
        by_one += image(polygon, s) == polygon;
        by_twice += image(image(polygon, s), s) == polygon;
      }
      fixed += by_one * by_one + by_twice;
    }
    EXPECT_EQ(fixed % (2 * square_symmetries), 0U);
    EXPECT_EQ(pair_orbits(all).size(), fixed / (2 * square_symmetries)) << side << most;
  }
}

TEST(PairOrbits, hold_one_pair_each) {
  const std::vector<GridPolygon> all = grid_polygons(3, 3);
  std::size_t members = 0;
  for (const auto& [i, j] : pair_orbits(all)) {
    std::set<std::pair<GridPolygon, GridPolygon>> orbit;
    for (std::size_t s = 0; s < square_symmetries; ++s) {
      orbit.emplace(image(all[i], s), image(all[j], s));
      orbit.emplace(image(all[j], s), image(all[i], s));
    }
    members += orbit.size();
  }
  EXPECT_EQ(members, all.size() * all.size());
}

}  // namespace
}  // namespace oplus
