// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/cells.hpp"

#include <gtest/gtest.h>

#include "reference/chains/validity.hpp"

namespace oplus {
namespace {

Cells three_by_three_without(const Cells& missing) {
  Cells cells;
  for (int i = 0; i < 9; ++i)
    if (!missing.contains({i % 3, i / 3})) cells.emplace(i % 3, i / 3);
  return cells;
}

TEST(RegionOfCells, one_cell_is_a_square) {
  EXPECT_EQ(region_of_cells({{2, 3}}), polygon({{2, 3}, {3, 3}, {3, 4}, {2, 4}}));
}

TEST(RegionOfCells, a_ring_has_a_hole) {
  const Region expected{{{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  EXPECT_EQ(region_of_cells(three_by_three_without({{1, 1}})), expected);
}

TEST(RegionOfCells, cells_that_share_a_corner_are_two_components) {
  const Region region = region_of_cells({{0, 0}, {1, 1}});
  EXPECT_EQ(region.components.size(), 2u);
  EXPECT_EQ(vertex_count(region), 8u);
  EXPECT_EQ(find_defect(region), std::nullopt);
}

TEST(RegionOfCells, a_ring_open_at_a_corner_only_has_a_touching_hole) {
  const Region region = region_of_cells(three_by_three_without({{1, 1}, {2, 2}}));
  ASSERT_EQ(region.components.size(), 1u);
  EXPECT_EQ(region.components[0].outer.size(), 6u);
  ASSERT_EQ(region.components[0].holes.size(), 1u);
  EXPECT_EQ(find_defect(region), std::nullopt);
  EXPECT_EQ(area(region), 7);
}

TEST(RegionOfCells, every_set_of_nine_cells_is_valid_and_has_its_area) {
  for (unsigned bits = 1; bits < 512; ++bits) {
    Cells cells;
    for (int i = 0; i < 9; ++i)
      if ((bits >> i & 1u) != 0) cells.emplace(i % 3, i / 3);
    const Region region = region_of_cells(cells);
    ASSERT_EQ(find_defect(region), std::nullopt) << bits;
    ASSERT_EQ(area(region), static_cast<unsigned long>(cells.size())) << bits;
  }
}

}  // namespace
}  // namespace oplus
