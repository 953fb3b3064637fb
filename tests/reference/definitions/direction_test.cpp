// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/direction.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

/// All directions of a 5x5 grid, counterclockwise from the positive x-axis, listed by hand.
const std::vector<Vector> circle = {{1, 0},  {2, 1},  {1, 1},  {1, 2},   {0, 1},   {-1, 2},
                                    {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2},
                                    {0, -1}, {1, -2}, {1, -1}, {2, -1}};

/// A vector of the grid and its place on the circle.
struct Placed {
  Vector vector;
  std::size_t place;
};

std::vector<Placed> grid_vectors() {
  std::vector<Placed> all;
  for (std::size_t i = 0; i < circle.size(); ++i) {
    all.push_back({circle[i], i});
    if (i % 2 == 0) all.push_back({Rational(2) * circle[i], i});  // the longer ones of the grid
  }
  return all;
}

int sign_of_difference(std::size_t a, std::size_t b) { return a < b ? -1 : a > b ? 1 : 0; }

TEST(Direction, compare_angle_is_the_order_around_the_circle) {
  const std::vector<Placed> all = grid_vectors();
  ASSERT_EQ(all.size(), 24u);
  for (const Placed& u : all) {
    for (const Placed& v : all) {
      const int order = compare_angle(u.vector, v.vector);
      ASSERT_EQ((order > 0) - (order < 0), sign_of_difference(u.place, v.place))
          << testing::PrintToString(u.vector) << ' ' << testing::PrintToString(v.vector);
      ASSERT_EQ(same_direction(u.vector, v.vector), u.place == v.place);
    }
  }
}

TEST(Direction, compare_angle_agrees_with_the_skew_product_within_half_a_turn) {
  for (const Placed& u : grid_vectors()) {
    for (const Placed& v : grid_vectors()) {
      const std::size_t turn = (v.place + 16 - u.place) % 16;
      const int expected = turn == 0 || turn == 8 ? 0 : turn < 8 ? 1 : -1;
      ASSERT_EQ(sign(cross(u.vector, v.vector)), expected);
      if ((u.place < 8) == (v.place < 8) && turn != 0) {
        ASSERT_EQ(compare_angle(u.vector, v.vector) < 0, expected > 0);
      }
    }
  }
}

TEST(Direction, of_equal_ones_that_of_q_comes_after) {
  EXPECT_LT(compare({{1, 2}, Summand::P}, {{2, 4}, Summand::Q}), 0);
  EXPECT_GT(compare({{1, 2}, Summand::Q}, {{2, 4}, Summand::P}), 0);
  EXPECT_EQ(compare({{1, 2}, Summand::Q}, {{2, 4}, Summand::Q}), 0);
  EXPECT_LT(compare({{1, 2}, Summand::Q}, {{1, 3}, Summand::P}), 0) << "angles come first";
  EXPECT_EQ(other(Summand::P), Summand::Q);
  EXPECT_EQ(other(Summand::Q), Summand::P);
}

/// Places 2i for P, 2i + 1 for Q: walks the circle step by step.
bool met_before(std::size_t d, std::size_t from, std::size_t to) {
  if (from == to) return false;
  for (std::size_t at = (from + 1) % 32; at != to; at = (at + 1) % 32)
    if (at == d) return true;
  return false;
}

TEST(Direction, counterclockwise_between_is_what_a_walk_around_the_circle_meets) {
  struct OnCircle {
    Direction direction;
    std::size_t place;
  };
  std::vector<OnCircle> all;
  for (std::size_t i = 0; i < circle.size(); ++i) {
    all.push_back({{circle[i], Summand::P}, 2 * i});
    all.push_back({{circle[i], Summand::Q}, 2 * i + 1});
  }
  all.push_back({{{2, 0}, Summand::P}, 0});
  all.push_back({{{-2, 2}, Summand::Q}, 13});
  for (const OnCircle& d : all)
    for (const OnCircle& from : all)
      for (const OnCircle& to : all)
        ASSERT_EQ(counterclockwise_between(d.direction, from.direction, to.direction),
                  met_before(d.place, from.place, to.place))
            << d.place << ' ' << from.place << ' ' << to.place;
}

}  // namespace
}  // namespace oplus
