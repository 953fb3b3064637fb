// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle/set_by_pieces.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Region square = polygon(box(0, 0, 4, 4));
const Region frame = holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)});

Region complement_of_box(const Chain& chain) { return {{{{}, {backwards(chain)}}}}; }

TEST(SetByPieces, contains_its_boundary_edges_and_points) {
  const SetByPieces set =
      set_by_pieces(PlanarSet{{box(0, 0, 1, 1)}, {}, {{{1, 0}, {3, 0}}}, {{5, 5}}});
  for (const Point& p :
       {Point{0, 0}, Point{Rational(1, 2), Rational(1, 2)}, Point{2, 0}, Point{5, 5}})
    EXPECT_TRUE(set.contains(p));
  EXPECT_FALSE(set.contains({2, 1}));
  EXPECT_FALSE(set.contains({4, 0}));
}

TEST(SetByPieces, unbounded_contains_all_but_its_holes) {
  const SetByPieces set = set_by_pieces(complement_of_box(box(0, 0, 2, 2)));
  EXPECT_TRUE(set.contains({100, 100}));
  EXPECT_TRUE(set.contains({2, 1}));
  EXPECT_FALSE(set.contains({1, 1}));
}

TEST(Meet, closed_sets_meet_where_they_touch) {
  const SetByPieces a = set_by_pieces(square);
  EXPECT_TRUE(meet(a, set_by_pieces(polygon(box(4, 4, 5, 5)))));
  EXPECT_TRUE(meet(a, set_by_pieces(polygon(box(1, 1, 2, 2)))));
  EXPECT_TRUE(meet(set_by_pieces(polygon(box(1, 1, 2, 2))), a));
  EXPECT_FALSE(meet(a, set_by_pieces(polygon(box(5, 5, 6, 6)))));
  EXPECT_TRUE(meet(set_by_pieces(polygon(box(1, -1, 2, 5))), a));
}

TEST(Meet, a_set_in_a_hole_does_not_meet_what_is_around_it) {
  EXPECT_TRUE(meet(set_by_pieces(frame), set_by_pieces(polygon(box(1, 1, 2, 2)))));
  const SetByPieces inside = set_by_pieces(polygon(box(Rational(3, 2), Rational(3, 2), 2, 2)));
  EXPECT_FALSE(meet(set_by_pieces(frame), inside));
  EXPECT_TRUE(meet(set_by_pieces(complement_of_box(box(0, 0, 1, 1))), set_by_pieces(square)));
  EXPECT_FALSE(meet(set_by_pieces(complement_of_box(box(0, 0, 5, 5))), inside));
  EXPECT_TRUE(meet(set_by_pieces(Region{{{{}, {}}}}), inside));
  EXPECT_FALSE(meet(set_by_pieces(Region{}), inside));
  EXPECT_TRUE(meet(set_by_pieces(Region{{{{}, {}}}}), set_by_pieces(Region{{{{}, {}}}})));
}

TEST(IsSubset, of_regions_that_touch_from_inside) {
  EXPECT_TRUE(is_subset(set_by_pieces(square), set_by_pieces(square)));
  EXPECT_TRUE(is_subset(set_by_pieces(frame), set_by_pieces(square)));
  // All of its vertices are in the other one.
  EXPECT_FALSE(is_subset(set_by_pieces(square), set_by_pieces(frame)));
  EXPECT_FALSE(is_subset(set_by_pieces(polygon(box(1, 0, 3, 4))), set_by_pieces(frame)));
  EXPECT_TRUE(is_subset(set_by_pieces(polygon(box(0, 0, 1, 4))), set_by_pieces(frame)));
  EXPECT_TRUE(is_subset(set_by_pieces(Region{}), set_by_pieces(Region{})));
}

TEST(IsSubset, of_unbounded_regions) {
  const SetByPieces outside = set_by_pieces(complement_of_box(box(0, 0, 4, 4)));
  const SetByPieces more = set_by_pieces(complement_of_box(box(1, 1, 4, 4)));
  EXPECT_TRUE(is_subset(outside, more));
  EXPECT_FALSE(is_subset(more, outside));
  EXPECT_FALSE(is_subset(outside, set_by_pieces(square)));
  EXPECT_FALSE(is_subset(set_by_pieces(Region{{{{}, {}}}}), set_by_pieces(square)));
  EXPECT_TRUE(is_subset(set_by_pieces(polygon(box(4, 4, 5, 5))), outside));
}

}  // namespace
}  // namespace oplus
