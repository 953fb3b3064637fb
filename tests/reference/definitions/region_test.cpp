// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/region.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/cells.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Chain hole = backwards(box(1, 1, 2, 2));
const Chain second_hole = backwards(box(3, 1, 4, 3));
const Region two_holes_and_an_island{
    {{box(0, 0, 5, 5), {hole, second_hole}}, {box(6, 0, 7, 1), {}}}};

TEST(Region, chains_are_of_each_component_the_outer_one_then_its_holes) {
  EXPECT_EQ(chains(two_holes_and_an_island),
            (std::vector<Chain>{box(0, 0, 5, 5), hole, second_hole, box(6, 0, 7, 1)}));
  EXPECT_TRUE(chains(Region{}).empty());
}

TEST(Region, edge_i_leaves_vertex_i_and_the_last_closes_the_chain) {
  EXPECT_EQ(edges(Chain{{0, 0}, {3, 0}, {0, 3}}),
            (std::vector<Segment>{{{0, 0}, {3, 0}}, {{3, 0}, {0, 3}}, {{0, 3}, {0, 0}}}));
}

TEST(Region, edges_are_in_the_order_of_chains) {
  std::vector<Segment> expected;
  for (const Chain& chain : chains(two_holes_and_an_island))
    for (const Segment& e : edges(chain)) expected.push_back(e);
  EXPECT_EQ(edges(two_holes_and_an_island), expected);
  EXPECT_EQ(vertex_count(two_holes_and_an_island), 16u);
}

TEST(Region, previous_and_next_go_around) {
  EXPECT_EQ(previous(0, 3), 2u);
  EXPECT_EQ(previous(2, 3), 1u);
  EXPECT_EQ(next(2, 3), 0u);
  EXPECT_EQ(next(0, 3), 1u);
}

TEST(Region, area_does_not_count_holes) {
  EXPECT_EQ(twice_area({{0, 0}, {3, 0}, {0, 1}}), 3);
  EXPECT_EQ(twice_area({{0, 1}, {3, 0}, {0, 0}}), -3);
  EXPECT_EQ(area(two_holes_and_an_island), 25 - 1 - 2 + 1);
  EXPECT_EQ(area(Region{}), 0);
}

TEST(Region, translated_moves_every_chain) {
  const Region moved = translated(two_holes_and_an_island, {10, Rational(-1, 2)});
  const std::vector<Chain> before = chains(two_holes_and_an_island);
  const std::vector<Chain> after = chains(moved);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(after[i], translated(before[i], {10, Rational(-1, 2)}));
  EXPECT_EQ(after[1][0], (Point{11, Rational(3, 2)}));
}

TEST(Region, reflected_turns_every_point_over_and_keeps_orientations) {
  const Region turned = reflected(two_holes_and_an_island);
  EXPECT_EQ(area(turned), area(two_holes_and_an_island));
  EXPECT_EQ(turned.components[0].holes[0][0], -hole[0]);
  EXPECT_EQ(reflected(turned), two_holes_and_an_island);
}

TEST(Region, locate_tells_inside_boundary_and_outside) {
  EXPECT_EQ(locate({Rational(1, 2), 1}, two_holes_and_an_island), Location::inside);
  EXPECT_EQ(locate({Rational(3, 2), Rational(3, 2)}, two_holes_and_an_island), Location::outside);
  EXPECT_EQ(locate({1, Rational(3, 2)}, two_holes_and_an_island), Location::boundary);
  EXPECT_EQ(locate({0, 0}, two_holes_and_an_island), Location::boundary);
  EXPECT_EQ(locate({Rational(13, 2), Rational(1, 2)}, two_holes_and_an_island), Location::inside);
  EXPECT_EQ(locate({Rational(11, 2), Rational(1, 2)}, two_holes_and_an_island), Location::outside);
  EXPECT_EQ(locate({0, 0}, Region{}), Location::outside);
}

TEST(Region, locate_agrees_with_parity_in_every_cell) {
  for (const Shape& shape : shapes()) {
    const std::set<Cell> in_shape = cells_of(shape.region);
    for (const Cell& cell : cells(-1, 9))
      ASSERT_EQ(locate(point_in(cell), shape.region),
                in_shape.contains(cell) ? Location::inside : Location::outside)
          << shape.name;
  }
}

}  // namespace
}  // namespace oplus
