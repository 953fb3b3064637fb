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

Region shape(const std::string& name) {
  for (const Shape& s : shapes())
    if (s.name == name) return s.region;
  throw std::invalid_argument("no shape " + name);
}

/// The box is where -Q+x is to stand.
ComponentsAndHoles with_box(const Region& p, const Rational& x0, const Rational& y0,
                            const Rational& x1, const Rational& y1) {
  return intersection_components(p, polygon(box(0, 0, x1 - x0, y1 - y0)), {x1, y1});
}

const Rational half(1, 2);

TEST(IntersectionComponents, of_squares) {
  const Region square = polygon(box(0, 0, 2, 2));
  EXPECT_EQ(with_box(square, 3, 3, 4, 4), none);
  EXPECT_EQ(with_box(square, 1, 1, 4, 4), one);
  EXPECT_EQ(with_box(square, -1, -1, 4, 4), one) << "inside";
  EXPECT_EQ(with_box(square, half, half, 1, 1), one) << "around";
  EXPECT_EQ(with_box(square, -1, half, 4, 1), one) << "across";
}

TEST(IntersectionComponents, q_is_reflected) {
  const Region triangle = polygon({{0, 0}, {4, 0}, {0, 4}});
  EXPECT_EQ(intersection_components(triangle, triangle, {5, half}), one);
  EXPECT_EQ(intersection_components(triangle, triangle, {-half, -half}), none);
}

TEST(IntersectionComponents, of_a_u_and_a_bar) {
  const Region u = shape("U");
  EXPECT_EQ(with_box(u, -1, Rational(3, 2), 4, 2), two) << "through both arms";
  EXPECT_EQ(with_box(u, -1, half, 4, 2), one) << "and the base";
  EXPECT_EQ(with_box(u, half, Rational(3, 2), Rational(3, 2), 2), one) << "one arm";
  EXPECT_EQ(with_box(u, Rational(5, 4), Rational(3, 2), Rational(7, 4), 2), none) << "between";
}

TEST(IntersectionComponents, of_two_us) {
  const Region u = shape("U");  // -U+x has its arms below
  EXPECT_EQ(intersection_components(u, u, {Rational(7, 2), Rational(9, 2)}), two) << "arm on arm";
  EXPECT_EQ(intersection_components(u, u, {Rational(9, 2), Rational(9, 2)}), one)
      << "an arm between the other's arms and on one of them";
}

TEST(IntersectionComponents, of_a_frame) {
  const Region frame = shape("frame");
  EXPECT_EQ(with_box(frame, half, half, Rational(5, 2), Rational(5, 2)), ring) << "hole covered";
  EXPECT_EQ(with_box(frame, -1, -1, 4, 4), ring) << "all covered";
  EXPECT_EQ(with_box(frame, Rational(5, 4), Rational(5, 4), Rational(7, 4), Rational(7, 4)), none)
      << "in the hole";
  EXPECT_EQ(with_box(frame, -1, Rational(5, 4), 4, Rational(7, 4)), two) << "across the hole";
  EXPECT_EQ(with_box(frame, half, Rational(5, 4), Rational(3, 2), Rational(7, 4)), one)
      << "into the hole";
  EXPECT_EQ(ring.euler_characteristic(), 0);
}

TEST(IntersectionComponents, of_two_frames) {
  const Region wide{{{box(0, 0, 8, 8), {backwards(box(1, 1, 7, 7))}}}};
  const Region narrow{{{box(0, 0, 4, 4), {backwards(box(1, 1, 3, 3))}}}};
  EXPECT_EQ(intersection_components(wide, narrow, {6, 6}), none) << "in its hole";
  EXPECT_EQ(intersection_components(wide, narrow, {Rational(19, 2), 6}), two)
      << "its right side outside, upper and lower side through";
  EXPECT_EQ(intersection_components(wide, narrow, {half + 7, 6}), one) << "not yet all of it";
}

TEST(IntersectionComponents, of_several_components) {
  EXPECT_EQ(with_box(shape("two squares apart"), -1, -1, 4, 4), two);
  EXPECT_EQ(with_box(shape("island in a hole"), -1, -1, 6, 6), (ComponentsAndHoles{2, 1}));
  EXPECT_EQ(with_box(shape("island in a hole"), Rational(3, 2), Rational(3, 2), Rational(7, 2),
                     Rational(7, 2)),
            one);
}

TEST(IntersectionComponents, where_chains_touch_are_those_of_the_interior) {
  EXPECT_EQ(with_box(shape("two squares touching in a corner"), -1, -1, 3, 3), two);
  EXPECT_EQ(with_box(shape("hole touching the outer chain"), -1, -1, 5, 5), one)
      << "the hole is joined to the outside";
  EXPECT_EQ(
      with_box(shape("hole touching the outer chain"), half, half, Rational(7, 2), Rational(7, 2)),
      one)
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
  const Region frame{{{outer, {backwards(hole)}}}};
  for (const Region& p : {polygon(outer), polygon(hole), frame})
    EXPECT_EQ(with_box(p, 3, Rational(5, 2), 5, Rational(7, 2)), one);
  // Across the whole hole: 1, 1 and 2.
  for (const Region& p : {polygon(outer), polygon(hole)})
    EXPECT_EQ(with_box(p, 1, Rational(5, 2), 5, Rational(7, 2)), one);
  EXPECT_EQ(with_box(frame, 1, Rational(5, 2), 5, Rational(7, 2)), two);
}

TEST(IntersectionComponents, with_the_empty_region_is_empty) {
  EXPECT_EQ(intersection_components(Region{}, shape("U"), {0, 0}), none);
  EXPECT_EQ(intersection_components(shape("U"), Region{}, {0, 0}), none);
}

}  // namespace
}  // namespace oplus
