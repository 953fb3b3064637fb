// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/strip.hpp"

#include <gtest/gtest.h>

#include "tests/checked/slide/exact_values.hpp"

namespace oplus::slide {
namespace {

TEST(Strip, never_separates_what_has_a_point_in_common) {
  Random random(5);
  for (const double scale : {1.0, 0x1p-70, 0x1p40}) {
    for (int k = 0; k < 20000; ++k) {
      const auto number = [&] { return scale * uniform(random, -1000000, 1000000); };
      const NearSegment e{number(), number(), number(), number()};
      const NearSegment f{number(), number(), number(), number()};
      // A place in the sum, or nearly: rounded.
      const double a = uniform(random, 0, 8) / 8.0, b = uniform(random, 0, 8) / 8.0;
      const double x = e.x + a * e.dx + f.x + b * f.dx, y = e.y + a * e.dy + f.y + b * f.dy;
      const ApproximatePoint at{x, y, 0}, away{x + number(), y + number(), 0};
      const FloatBox box = box_around(f.x, f.y, f.x + f.dx, f.y + f.dy);
      EXPECT_FALSE(is_beside(strip_along(e), f, at, at));
      EXPECT_FALSE(is_beside(strip_along(e), f, at, away));
      EXPECT_FALSE(is_beside(strip_along(e), box, away, at));
    }
  }
}

/// The numbers are rounded, and so are the places that are computed from them.
TEST(NearSegment, is_no_farther_off_than_is_said) {
  Random random(6);
  for (int k = 0; k < 20000; ++k) {
    const auto number = [&] {
      const Rational odd = odd_number(random, static_cast<unsigned>(uniform(random, 1, 62)));
      return one_in(random, 2) ? odd : Rational(-odd);
    };
    struct Exact {
      Rational x, y, dx, dy;
      NearSegment near() const { return {x.get_d(), y.get_d(), dx.get_d(), dy.get_d()}; }
    };
    const Exact e{number(), number(), number(), number()},
        f{number(), number(), number(), number()};
    const NearSegment near_e = e.near(), near_f = f.near();
    const Rational place = e.dx * e.y - e.dy * e.x;
    const Strip strip = strip_along(near_e);
    EXPECT_TRUE(strip.low < place && place < strip.high);
    for (const double t : {0.0, 0.5, 1.0}) {
      const auto is_off = [&](double near, const Rational& exact) {
        return Rational(abs(near - exact));
      };
      EXPECT_LT(is_off(near_e.x + near_f.x + t * near_e.dx, e.x + f.x + t * e.dx),
                error_of_places(near_e, near_f));
      EXPECT_LT(is_off(near_e.y + near_f.y + t * near_e.dy, e.y + f.y + t * e.dy),
                error_of_places(near_e, near_f));
    }
  }
}

TEST(Strip, separates_what_is_beside_it) {
  const Strip strip = strip_along({0, 0, 100, 100});
  const NearSegment along{0, 0, 10, 10};
  EXPECT_TRUE(is_beside(strip, along, {5, 6}, {5, 6}));
  EXPECT_FALSE(is_beside(strip, along, {5, 6, 1}, {5, 6, 1})) << "off by as much";
  EXPECT_TRUE(is_beside(strip, along, {5, 6}, {7, 9}));
  EXPECT_FALSE(is_beside(strip, along, {5, 6}, {6, 5})) << "on both sides";
  EXPECT_FALSE(is_beside(strip, box_around(0, 0, 10, 10), {5, 6}, {5, 6}));
  EXPECT_TRUE(is_beside(strip, box_around(0, 0, 10, 10), {5, 16}, {5, 16}));
}

}  // namespace
}  // namespace oplus::slide
