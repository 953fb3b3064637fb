// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/grid_promises.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const PlanarSet given = canonical_sum(polygon(box(0, 0, 5, 5)));

/// What is wrong with a box instead of the given set, on the grid of step 2.
std::string kind_of(const Chain& chain, Side side, const Rational& bound) {
  RoundedSet result;
  result.set = canonical_sum(polygon(chain));
  result.bound = bound;
  const std::optional<Failure> broken = broken_promise(given, result, 2, side);
  return broken ? broken->kind : "";
}

TEST(BrokenPromise, is_none_of_what_is_rounded) {
  for (const Side side : {Side::nearest, Side::contain, Side::contained})
    EXPECT_FALSE(broken_promise(given, rounded(given, Boundary::closed, 2, side), 2, side));
  EXPECT_EQ(kind_of(box(0, 0, 6, 4), Side::nearest, 1), "");
  EXPECT_EQ(kind_of(box(0, 0, 6, 6), Side::contain, 2), "");
  EXPECT_EQ(kind_of(box(0, 0, 4, 4), Side::contained, 2), "");
}

TEST(BrokenPromise, names_a_vertex_off_the_grid) {
  EXPECT_EQ(kind_of(box(0, 0, 5, 4), Side::nearest, 2), "off the grid");
}

TEST(BrokenPromise, names_a_point_on_the_wrong_side) {
  EXPECT_EQ(kind_of(box(0, 0, 6, 4), Side::contain, 2), "side not kept");
  EXPECT_EQ(kind_of(box(0, 0, 6, 4), Side::contained, 2), "side not kept");
  EXPECT_EQ(kind_of(box(-2, 0, 4, 4), Side::contained, 2), "side not kept");
}

TEST(BrokenPromise, names_a_point_beyond_the_bound) {
  EXPECT_EQ(kind_of(box(0, 0, 8, 6), Side::contain, 2), "beyond the bound");
  EXPECT_EQ(kind_of(box(0, 0, 6, 4), Side::nearest, Rational(1, 2)), "beyond the bound");
  EXPECT_EQ(kind_of(box(2, 2, 4, 4), Side::contained, 1), "beyond the bound");
}

}  // namespace
}  // namespace oplus
