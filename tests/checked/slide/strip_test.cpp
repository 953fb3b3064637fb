// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/strip.hpp"

#include <gtest/gtest.h>

#include "reference/families/random.hpp"

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
