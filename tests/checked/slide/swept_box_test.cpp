// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/swept_box.hpp"

#include <gtest/gtest.h>

#include "reference/definitions/region.hpp"
#include "reference/families/random.hpp"

namespace oplus::slide {
namespace {

struct Corners {
  int low_x, low_y, high_x, high_y;
};

FloatBox box_of(const Corners& c) { return box_around(c.low_x, c.low_y, c.high_x, c.high_y); }

/// Whether a segment and a closed box have a point in common, by clipping with rationals.
bool meet(const Point& a, const Point& b, const Corners& c) {
  Rational from = 0, to = 1;
  const auto clip = [&](const Rational& source, const Rational& target, int low, int high) {
    if (source == target) return low <= source && source <= high;
    const Rational first = (low - source) / (target - source);
    const Rational last = (high - source) / (target - source);
    from = std::max(from, std::min(first, last));
    to = std::min(to, std::max(first, last));
    return from <= to;
  };
  return clip(a.x, b.x, c.low_x, c.high_x) && clip(a.y, b.y, c.low_y, c.high_y);
}

/// `reach` is the largest coordinate.
void expect_no_meeting_rejected(int reach, std::uint64_t seed) {
  Random random(seed);
  const auto number = [&] { return uniform(random, -reach, reach); };
  std::size_t met = 0, rejected = 0;
  for (int k = 0; k < 5000; ++k) {
    const int ax = number(), ay = number(), dx = number() - ax, dy = number() - ay;
    const Point a{ax, ay}, b{ax + dx, ay + dy};
    const SweptBox swept({double(ax), double(ay)}, {double(ax + dx), double(ay + dy)});
    Corners c{number(), number(), 0, 0};
    if (one_in(random, 2)) {
      // A corner on the segment, or nearly.
      const int part = uniform(random, 0, 64);
      c.low_x = ax + static_cast<int>(std::int64_t{dx} * part / 64);
      c.low_y = ay + static_cast<int>(std::int64_t{dy} * part / 64);
    }
    c.high_x = c.low_x + uniform(random, 0, reach / 4);
    c.high_y = c.low_y + uniform(random, 0, reach / 4);
    if (one_in(random, 2)) {
      const int width = c.high_x - c.low_x;
      c.high_x = c.low_x;
      c.low_x -= width;
    }
    if (meet(a, b, c)) {
      ++met;
      EXPECT_TRUE(swept.may_meet(box_of(c)))
          << a.x << ' ' << a.y << ", " << b.x << ' ' << b.y << ": " << c.low_x << ' ' << c.low_y
          << ' ' << c.high_x << ' ' << c.high_y;
    } else if (!swept.may_meet(box_of(c))) {
      ++rejected;
    }
  }
  EXPECT_GT(met, 1000u);
  EXPECT_GT(rejected, 1000u);
}

TEST(SweptBox, never_rejects_what_the_segment_meets) {
  expect_no_meeting_rejected(8, 1);
  expect_no_meeting_rejected(1000, 2);
  expect_no_meeting_rejected(0x1fffffff, 3);
}

TEST(SweptBox, rejects_what_is_beside_the_segment_though_in_its_box) {
  const SweptBox swept({0, 0}, {8, 8});
  EXPECT_FALSE(swept.may_meet(box_of(Corners{5, 1, 7, 3})));
  EXPECT_FALSE(swept.may_meet(box_of(Corners{1, 5, 3, 7})));
  EXPECT_TRUE(swept.may_meet(box_of(Corners{5, 1, 7, 5}))) << "a corner";
  EXPECT_TRUE(swept.may_meet(box_of(Corners{1, 3, 3, 7}))) << "the corner across";
  EXPECT_FALSE(swept.may_meet(box_of(Corners{9, 9, 10, 10}))) << "on its line";
  EXPECT_FALSE(swept.may_meet(box_of(Corners{-2, -2, -1, -1}))) << "on its line";
}

TEST(SweptBox, meets_what_is_nearer_than_its_ends_can_be_off) {
  const SweptBox swept({0, 0, 2}, {8, 8, 2});
  EXPECT_TRUE(swept.may_meet(box_of(Corners{5, 1, 7, 4})));
  EXPECT_TRUE(swept.may_meet(box_of(Corners{9, 9, 10, 10})));
  EXPECT_FALSE(swept.may_meet(box_of(Corners{11, 11, 12, 12})));
}

TEST(SweptBox, leaves_nothing_out_beside_a_short_piece_of_a_steep_line) {
  // In doubles, the ends have one x.
  SweptBox swept({1023.875, 0}, {1023.875, 0x1p-20});
  swept.leave_out_touching({1023, 0, 1, 0x1p23}, false);
  EXPECT_TRUE(swept.may_meet(box_of({1000, -1, 1024, 1})));
}

}  // namespace
}  // namespace oplus::slide
