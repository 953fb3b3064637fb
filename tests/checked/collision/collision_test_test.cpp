// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/collision_test.hpp"

#include <gtest/gtest.h>

#include "checked/operations/image.hpp"
#include "tests/checked/collision/each_method.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(EachCollision, does_not_depend_on_what_was_asked_before) {
  const Region square = polygon(box(0, 0, 2, 2));
  const EachMethod each(square, square);
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_EQ(each.wrong_at({2, 2}, true), "") << "equal";
    EXPECT_EQ(each.wrong_at({4, 2}, false), "") << "side by side";
    EXPECT_EQ(each.wrong_at({3, 3}, true), "") << "crossing";
    EXPECT_EQ(each.wrong_at({9, 9}, false), "") << "apart";
  }
}

TEST(EachCollision, with_the_empty_region_never_holds) {
  const Region square = polygon(box(-1, -1, 1, 1));
  EXPECT_EQ(EachMethod(Region{}, square).wrong_at({0, 0}, false), "");
  EXPECT_EQ(EachMethod(square, Region{}).wrong_at({0, 0}, false), "");
}

TEST(EachCollision, is_right_where_coordinates_are_no_doubles) {
  const Rational huge("1" + std::string(400, '0'));
  const std::vector<Shape> all = shapes();
  for (const Rational& factor : {huge, Rational(1 / huge)}) {
    for (std::size_t k = 0; k < all.size(); k += 2) {
      const Region& p = all[k].region;
      const Region& q = all[(k + 5) % all.size()].region;
      const Vector away = factor * Vector{-3, 4};
      const auto plain = hierarchy_collision(p, q);
      const EachMethod each(translated(image(scaled_by(factor), p), away),
                            image(scaled_by(factor), q));
      for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 8; ++j) {
          ASSERT_EQ(each.wrong_at(factor * Point{i, j} + away, plain->interiors_meet_at({i, j})),
                    "")
              << all[k].name << ' ' << i << ' ' << j;
        }
      }
    }
  }
}

TEST(EachCollision, sees_less_than_a_double_can_hold) {
  const Rational tiny = 1 / Rational("1" + std::string(400, '0'));
  const Region square = polygon(box(0, 0, 1, 1));
  const EachMethod each(square, square);
  EXPECT_EQ(each.wrong_at({2 - tiny, 1}, true), "");
  EXPECT_EQ(each.wrong_at({2 + tiny, 1}, false), "");
  EXPECT_EQ(each.wrong_at({1 + tiny, 1 - tiny}, true), "");
}

}  // namespace
}  // namespace oplus
