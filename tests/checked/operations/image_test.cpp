// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/image.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"

namespace oplus {
namespace {

const Region frame = {{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}}}};
const AffineMap mirror{-1, 0, 0, 1};

TEST(AffineMap, is_combined_from_the_right) {
  const AffineMap turn{0, -1, 1, 0}, move{.by = {1, 2}};
  EXPECT_EQ(turn({3, 5}), (Point{-5, 3}));
  EXPECT_EQ((move * turn)({3, 5}), (Point{-4, 5}));
  EXPECT_EQ((turn * move)({3, 5}), (Point{-7, 4}));
  EXPECT_EQ(turn * turn * turn * turn, AffineMap{});
  EXPECT_EQ((scaling(3) * mirror).determinant(), -9);
}

TEST(Image, keeps_the_first_vertex_and_the_interior_on_the_left) {
  const Region expected = {
      {{{{0, 0}, {0, 4}, {-4, 4}, {-4, 0}}, {{{-1, 1}, {-3, 1}, {-3, 3}, {-1, 3}}}}}};
  EXPECT_EQ(image(mirror, frame), expected);
  EXPECT_EQ(image(scaling(2), frame).components[0].outer[1], (Point{8, 0}));
}

TEST(Image, of_an_unbounded_region_is_unbounded) {
  const Region outside = {{{{}, {{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}}}};
  const Region expected = {{{{}, {{{0, 0}, {-1, 0}, {-1, 1}, {0, 1}}}}}};
  EXPECT_EQ(image(mirror, outside), expected);
  const MinkowskiSum set = image(mirror, canonical_sum(outside));
  EXPECT_TRUE(set.is_unbounded);
  EXPECT_EQ(set, canonical_sum(expected));
  MinkowskiSum plane;
  plane.is_unbounded = true;
  EXPECT_EQ(image(mirror, plane), plane);
}

TEST(Image, of_a_set_is_canonical) {
  // Two squares that touch in a corner: which chain goes on there depends on left and right.
  MinkowskiSum set = canonical_sum(
      Region{{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {}}}});
  set.dangling_edges = {{{3, 0}, {4, 0}}, {{3, 0}, {3, 1}}};
  set.isolated_vertices = {{5, 0}, {5, 1}};
  const MinkowskiSum there = image(mirror, set);
  EXPECT_EQ(there.dangling_edges, (std::vector<Segment>{{{-4, 0}, {-3, 0}}, {{-3, 0}, {-3, 1}}}));
  EXPECT_EQ(there.isolated_vertices, (std::vector<Point>{{-5, 0}, {-5, 1}}));
  EXPECT_EQ(canonical_sum(region_of(there)).outer, there.outer);
  EXPECT_EQ(area(there), 2);
  set.dangling_edges = {{{3, 0}, {3, 1}}, {{3, 0}, {4, 0}}};
  EXPECT_EQ(image(mirror, there), set);
}

}  // namespace
}  // namespace oplus
