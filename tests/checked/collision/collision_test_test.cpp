// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/collision_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "checked/operations/image.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/convolution.hpp"
#include "tests/checked/collision/each_method.hpp"
#include "tests/reference/definitions/cells.hpp"
#include "tests/reference/definitions/pairs_of_shapes.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

/// The largest coordinate of one of the `shapes()`.
int side(const Region& region) {
  Rational largest = 0;
  for (const Segment& e : edges(region)) largest = std::max({largest, e.source.x, e.source.y});
  return static_cast<int>(largest.get_num().get_si());
}

/// Each chain of such a region is slanted, so that its sums need thirds, fifths and sevenths.
std::vector<Shape> slanted_shapes() {
  return {
      {"triangle", polygon({{0, 0}, {7, 2}, {3, 5}})},
      {"arrow", polygon({{0, 0}, {5, 1}, {2, 2}, {1, 5}})},
      {"triangle in a triangle, and one beside",
       {{{{{0, 0}, {9, 1}, {2, 8}}, {{{2, 2}, {2, 4}, {4, 3}}}}, {{{9, 1}, {11, 3}, {8, 5}}, {}}}}},
  };
}

TEST(EachCollision, holds_where_the_summands_share_a_cell) {
  std::size_t meeting = 0;
  std::size_t apart = 0;
  for (const Shape& p : shapes()) {
    const std::set<Cell> in_p = cells_of(p.region);
    for (const Shape& q : shapes()) {
      const std::set<Cell> in_minus_q = cells_of(reflected(q.region));
      const auto hierarchy = hierarchy_collision(p.region, q.region);
      const EachMethod each(p.region, q.region);
      const int end = side(p.region) + side(q.region) + 1;
      // All half-integers for small shapes, integers for large ones.
      const int step = end <= 7 ? 1 : 2;
      for (int i = -2; i <= 2 * end; i += step) {
        for (int j = -2; j <= 2 * end; j += step) {
          const Point x{Rational(i) / 2, Rational(j) / 2};
          const bool expected = share_a_cell(in_p, in_minus_q, i, j);
          ASSERT_EQ(hierarchy->interiors_meet_at(x), expected)
              << p.name << " + " << q.name << " at " << testing::PrintToString(x);
          ++(expected ? meeting : apart);
          if ((meeting + apart) % 7 != 0) continue;  // the others take their time
          ASSERT_EQ(each.wrong_at(x, expected), "")
              << p.name << " + " << q.name << " at " << testing::PrintToString(x);
        }
      }
    }
  }
  EXPECT_GT(meeting, 5000u);
  EXPECT_GT(apart, 5000u);
}

void expect_definition(const EachMethod& each, const Region& p, const Region& q, const Point& x) {
  const bool meet = interiors_meet(p, translated(reflected(q), x));
  EXPECT_EQ(each.wrong_at(x, meet), "") << testing::PrintToString(x);
}

TEST(EachCollision, is_the_definition_on_every_vertex_edge_sum) {
  for (const Shape& p : slanted_shapes()) {
    for (const Shape& q : slanted_shapes()) {
      SCOPED_TRACE(p.name + " and " + q.name);
      const EachMethod each(p.region, q.region);
      for (const Segment& s : segments(vertex_edge_sum(p.region, q.region))) {
        for (const Rational& t : {Rational(0), Rational(1, 2), Rational(1, 3)})
          expect_definition(each, p.region, q.region, s.source + t * direction_of(s));
      }
    }
  }
}

TEST(EachCollision, is_the_definition_at_a_third_of_vertex_edge_sums) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const EachMethod each(p, q);
    const std::vector<Segment> sums = segments(vertex_edge_sum(p, q));
    for (std::size_t i = 0; i < sums.size(); i += 11)
      expect_definition(each, p, q, sums[i].source + Rational(1, 3) * direction_of(sums[i]));
  });
}

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
      const EachMethod each(translated(image(scaling(factor), p), away), image(scaling(factor), q));
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
