// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/intersection_components.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reference/definitions/shapes.hpp"

namespace oplus {

inline void PrintTo(const ComponentsAndHoles& seen, std::ostream* out) {
  *out << seen.components << " components, " << seen.holes << " holes";
}

namespace {

constexpr ComponentsAndHoles none{0, 0}, one{1, 0}, two{2, 0}, ring{1, 1};

/// The box is where -Q+x is to stand. Multiples of 1/4 are exact.
ComponentsAndHoles with_box(const Region& p, double x0, double y0, double x1, double y1) {
  return intersection_components(p, polygon(box(0, 0, x1 - x0, y1 - y0)), {x1, y1});
}

TEST(IntersectionComponents, of_squares) {
  const Region square = polygon(box(0, 0, 2, 2));
  EXPECT_EQ(with_box(square, 3, 3, 4, 4), none);
  EXPECT_EQ(with_box(square, 1, 1, 4, 4), one);
  EXPECT_EQ(with_box(square, -1, -1, 4, 4), one) << "inside";
  EXPECT_EQ(with_box(square, 0.5, 0.5, 1, 1), one) << "around";
  EXPECT_EQ(with_box(square, -1, 0.5, 4, 1), one) << "across";
}

TEST(IntersectionComponents, q_is_reflected) {
  const Region triangle = polygon({{0, 0}, {4, 0}, {0, 4}});
  EXPECT_EQ(intersection_components(triangle, triangle, {5, 0.5}), one);
  EXPECT_EQ(intersection_components(triangle, triangle, {-0.5, -0.5}), none);
}

TEST(IntersectionComponents, of_a_u_and_a_bar) {
  const Region u = shape("U");
  EXPECT_EQ(with_box(u, -1, 1.5, 4, 2), two) << "through both arms";
  EXPECT_EQ(with_box(u, -1, 0.5, 4, 2), one) << "and the base";
  EXPECT_EQ(with_box(u, 0.5, 1.5, 1.5, 2), one) << "one arm";
  EXPECT_EQ(with_box(u, 1.25, 1.5, 1.75, 2), none) << "between";
}

TEST(IntersectionComponents, of_two_us) {
  const Region u = shape("U");  // -U+x has its arms below
  EXPECT_EQ(intersection_components(u, u, {3.5, 4.5}), two) << "arm on arm";
  EXPECT_EQ(intersection_components(u, u, {4.5, 4.5}), one)
      << "an arm between the other's arms and on one of them";
}

TEST(IntersectionComponents, of_a_frame) {
  const Region frame = shape("frame");
  EXPECT_EQ(with_box(frame, 0.5, 0.5, 2.5, 2.5), ring) << "hole covered";
  EXPECT_EQ(with_box(frame, -1, -1, 4, 4), ring) << "all covered";
  EXPECT_EQ(with_box(frame, 1.25, 1.25, 1.75, 1.75), none) << "in the hole";
  EXPECT_EQ(with_box(frame, -1, 1.25, 4, 1.75), two) << "across the hole";
  EXPECT_EQ(with_box(frame, 0.5, 1.25, 1.5, 1.75), one) << "into the hole";
  EXPECT_EQ(ring.euler_characteristic(), 0);
}

TEST(IntersectionComponents, of_two_frames) {
  const Region wide = holed(box(0, 0, 8, 8), {box(1, 1, 7, 7)});
  const Region narrow = holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)});
  EXPECT_EQ(intersection_components(wide, narrow, {6, 6}), none) << "in its hole";
  EXPECT_EQ(intersection_components(wide, narrow, {9.5, 6}), two)
      << "its right side outside, upper and lower side through";
  EXPECT_EQ(intersection_components(wide, narrow, {7.5, 6}), one) << "not yet all of it";
}

TEST(IntersectionComponents, of_several_components) {
  EXPECT_EQ(with_box(shape("two squares apart"), -1, -1, 4, 4), two);
  EXPECT_EQ(with_box(shape("island in a hole"), -1, -1, 6, 6), (ComponentsAndHoles{2, 1}));
  EXPECT_EQ(with_box(shape("island in a hole"), 1.5, 1.5, 3.5, 3.5), one);
}

TEST(IntersectionComponents, where_chains_touch_are_those_of_the_interior) {
  EXPECT_EQ(with_box(shape("two squares touching in a corner"), -1, -1, 3, 3), two);
  EXPECT_EQ(with_box(shape("hole touching the outer chain"), -1, -1, 5, 5), one)
      << "the hole is joined to the outside";
  EXPECT_EQ(with_box(shape("hole touching the outer chain"), 0.5, 0.5, 3.5, 3.5), one)
      << "the box ends below the point in which they touch";
  EXPECT_EQ(with_box(shape("square with a diamond hole that touches each side"), -1, -1, 9, 9),
            (ComponentsAndHoles{4, 0}));
  EXPECT_EQ(with_box(shape("island touching its hole"), -1, -1, 5, 5), (ComponentsAndHoles{2, 1}))
      << "the island's exterior and the hole's are one";
}

TEST(IntersectionComponents, do_not_add_up_over_pairs_of_chains) {
  // Section 4.2.4 says they do. The bar reaches into the hole from one side: 1 for the frame's
  // outer chain, 1 for its hole, and the intersection has one component, neither 1 + 1 nor 1 - 1.
  const Chain outer = box(0, 0, 6, 6), hole = box(2, 2, 4, 4);
  const Region frame = holed(outer, {hole});
  for (const Region& p : {polygon(outer), polygon(hole), frame})
    EXPECT_EQ(with_box(p, 3, 2.5, 5, 3.5), one);
  // Across the whole hole: 1, 1 and 2.
  for (const Region& p : {polygon(outer), polygon(hole)})
    EXPECT_EQ(with_box(p, 1, 2.5, 5, 3.5), one);
  EXPECT_EQ(with_box(frame, 1, 2.5, 5, 3.5), two);
}

TEST(IntersectionComponents, with_the_empty_region_is_empty) {
  EXPECT_EQ(intersection_components(Region{}, shape("U"), {0, 0}), none);
  EXPECT_EQ(intersection_components(shape("U"), Region{}, {0, 0}), none);
}

}  // namespace
}  // namespace oplus
