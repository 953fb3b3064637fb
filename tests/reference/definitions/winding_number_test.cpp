// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/winding_number.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/cells.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

std::vector<Segment> both(std::vector<Segment> a, const std::vector<Segment>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(WindingNumber, counts_turns_with_their_sense) {
  const std::vector<Segment> square = edges(box(0, 0, 4, 4));
  const Point inside{1, 1};
  EXPECT_EQ(winding_number(inside, square), 1);
  EXPECT_EQ(winding_number(inside, edges(backwards(box(0, 0, 4, 4)))), -1);
  EXPECT_EQ(winding_number(inside, both(square, square)), 2);
  EXPECT_EQ(winding_number(inside, both(square, edges(backwards(box(-1, -1, 5, 5))))), 0);
  EXPECT_EQ(winding_number(inside, {}), 0);
}

TEST(WindingNumber, differs_between_the_lobes_of_a_figure_eight) {
  const std::vector<Segment> eight = edges(Chain{{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_EQ(winding_number({Rational(1, 4), 1}, eight), 1);
  EXPECT_EQ(winding_number({Rational(7, 4), 1}, eight), -1);
  EXPECT_EQ(winding_number({1, Rational(1, 4)}, eight), 0);
}

TEST(WindingNumber, is_right_where_the_ray_passes_through_vertices) {
  const std::vector<Segment> diamond = edges(Chain{{2, 0}, {4, 2}, {2, 4}, {0, 2}});
  EXPECT_EQ(winding_number({2, 2}, diamond), 1) << "one vertex, the boundary crosses there";
  EXPECT_EQ(winding_number({-1, 2}, diamond), 0) << "two such vertices";
  EXPECT_EQ(winding_number({-1, 0}, diamond), 0) << "lowest vertex, only touched";
  EXPECT_EQ(winding_number({-1, 4}, diamond), 0) << "highest vertex, only touched";
}

TEST(WindingNumber, is_right_where_the_ray_runs_along_an_edge) {
  const std::vector<Segment> stairs = edges(Chain{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {0, 2}});
  EXPECT_EQ(winding_number({-1, 0}, stairs), 0);
  EXPECT_EQ(winding_number({-1, 2}, stairs), 0);
  EXPECT_EQ(winding_number({-1, 4}, stairs), 0);
  EXPECT_EQ(winding_number({5, 2}, stairs), 1);
  EXPECT_EQ(winding_number({3, 4}, stairs), 0);
}

TEST(WindingNumber, of_a_region_is_one_inside_and_zero_outside) {
  for (const Shape& shape : shapes()) {
    const std::vector<Segment> boundary = edges(shape.region);
    const std::set<Cell> in_shape = cells_of(shape.region);
    for (const Cell& cell : cells(-1, 9))
      ASSERT_EQ(winding_number(point_in(cell), boundary), in_shape.contains(cell) ? 1 : 0)
          << shape.name;
  }
}

}  // namespace
}  // namespace oplus
