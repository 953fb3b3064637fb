// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle/closed_set.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Region square = polygon(box(0, 0, 4, 4));
const Region frame = holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)});

Region complement_of_box(const Chain& chain) { return {{{{}, {backwards(chain)}}}}; }

TEST(ClosedSet, contains_its_boundary_edges_and_points) {
  const ClosedSet set =
      closed_set(MinkowskiSum{{box(0, 0, 1, 1)}, {}, {{{1, 0}, {3, 0}}}, {{5, 5}}});
  for (const Point& p :
       {Point{0, 0}, Point{Rational(1, 2), Rational(1, 2)}, Point{2, 0}, Point{5, 5}})
    EXPECT_TRUE(set.contains(p));
  EXPECT_FALSE(set.contains({2, 1}));
  EXPECT_FALSE(set.contains({4, 0}));
}

TEST(ClosedSet, unbounded_contains_all_but_its_holes) {
  const ClosedSet set = closed_set(complement_of_box(box(0, 0, 2, 2)));
  EXPECT_TRUE(set.contains({100, 100}));
  EXPECT_TRUE(set.contains({2, 1}));
  EXPECT_FALSE(set.contains({1, 1}));
}

TEST(Meet, closed_sets_meet_where_they_touch) {
  const ClosedSet a = closed_set(square);
  EXPECT_TRUE(meet(a, closed_set(polygon(box(4, 4, 5, 5)))));
  EXPECT_TRUE(meet(a, closed_set(polygon(box(1, 1, 2, 2)))));
  EXPECT_TRUE(meet(closed_set(polygon(box(1, 1, 2, 2))), a));
  EXPECT_FALSE(meet(a, closed_set(polygon(box(5, 5, 6, 6)))));
  EXPECT_TRUE(meet(closed_set(polygon(box(1, -1, 2, 5))), a));
}

TEST(Meet, a_set_in_a_hole_does_not_meet_what_is_around_it) {
  EXPECT_TRUE(meet(closed_set(frame), closed_set(polygon(box(1, 1, 2, 2)))));
  const ClosedSet inside = closed_set(polygon(box(Rational(3, 2), Rational(3, 2), 2, 2)));
  EXPECT_FALSE(meet(closed_set(frame), inside));
  EXPECT_TRUE(meet(closed_set(complement_of_box(box(0, 0, 1, 1))), closed_set(square)));
  EXPECT_FALSE(meet(closed_set(complement_of_box(box(0, 0, 5, 5))), inside));
  EXPECT_TRUE(meet(closed_set(Region{{{{}, {}}}}), inside));
  EXPECT_FALSE(meet(closed_set(Region{}), inside));
  EXPECT_TRUE(meet(closed_set(Region{{{{}, {}}}}), closed_set(Region{{{{}, {}}}})));
}

TEST(IsSubset, of_regions_that_touch_from_inside) {
  EXPECT_TRUE(is_subset(closed_set(square), closed_set(square)));
  EXPECT_TRUE(is_subset(closed_set(frame), closed_set(square)));
  // All of its vertices are in the other one.
  EXPECT_FALSE(is_subset(closed_set(square), closed_set(frame)));
  EXPECT_FALSE(is_subset(closed_set(polygon(box(1, 0, 3, 4))), closed_set(frame)));
  EXPECT_TRUE(is_subset(closed_set(polygon(box(0, 0, 1, 4))), closed_set(frame)));
  EXPECT_TRUE(is_subset(closed_set(Region{}), closed_set(Region{})));
}

TEST(IsSubset, of_unbounded_regions) {
  const ClosedSet outside = closed_set(complement_of_box(box(0, 0, 4, 4)));
  const ClosedSet more = closed_set(complement_of_box(box(1, 1, 4, 4)));
  EXPECT_TRUE(is_subset(outside, more));
  EXPECT_FALSE(is_subset(more, outside));
  EXPECT_FALSE(is_subset(outside, closed_set(square)));
  EXPECT_FALSE(is_subset(closed_set(Region{{{{}, {}}}}), closed_set(square)));
  EXPECT_TRUE(is_subset(closed_set(polygon(box(4, 4, 5, 5))), outside));
}

}  // namespace
}  // namespace oplus
