// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/tangent_set.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(TangentSet, corner_has_the_edges_to_and_from_the_vertex) {
  const Chain chain{{0, 0}, {4, 1}, {2, 5}};
  const Corner first = corner_at(chain, 0), last = corner_at(chain, 2);
  EXPECT_EQ(first.in, (Vector{-2, -5}));
  EXPECT_EQ(first.out, (Vector{4, 1}));
  EXPECT_EQ(last.in, (Vector{-2, 4}));
  EXPECT_EQ(last.out, (Vector{-2, -5}));
}

TEST(TangentSet, reflex_vertices_are_those_that_turn_right) {
  EXPECT_FALSE(is_reflex({{1, 0}, {0, 1}}));
  EXPECT_TRUE(is_reflex({{1, 0}, {0, -1}}));
  EXPECT_FALSE(is_reflex({{1, 0}, {3, 0}})) << "inside a straight line";
  EXPECT_FALSE(is_reflex({{1, 0}, {-1, 1}})) << "an acute one";
  EXPECT_TRUE(is_reflex({{1, 0}, {-1, -1}}));
}

TEST(TangentSet, of_a_convex_vertex_is_what_the_edges_turn_through) {
  const Corner convex{{1, 0}, {0, 1}};
  EXPECT_TRUE(in_tangent_set({{1, 1}, Summand::P}, convex));
  EXPECT_FALSE(in_tangent_set({{-1, 1}, Summand::P}, convex));
  EXPECT_FALSE(in_tangent_set({{-1, -1}, Summand::P}, convex));
}

TEST(TangentSet, of_a_reflex_vertex_covers_more_than_half_a_turn) {
  const Corner reflex{{1, 0}, {0, -1}};
  for (const Vector& d : {Vector{1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}})
    EXPECT_TRUE(in_tangent_set({d, Summand::P}, reflex));
  EXPECT_FALSE(in_tangent_set({{1, -1}, Summand::P}, reflex));
}

TEST(TangentSet, of_a_vertex_inside_a_straight_line_is_empty) {
  for (const Vector& d : {Vector{1, 0}, {-1, 0}, {1, 1}, {0, 1}, {-1, -1}, {2, -1}}) {
    EXPECT_FALSE(in_tangent_set({d, Summand::P}, {{1, 0}, {2, 0}}));
    EXPECT_FALSE(in_tangent_set({d, Summand::Q}, {{1, 0}, {2, 0}}));
  }
}

TEST(TangentSet, ties_are_decided_by_the_summand_of_the_direction) {
  const Corner convex{{1, 0}, {0, 1}};
  EXPECT_FALSE(in_tangent_set({{1, 0}, Summand::P}, convex)) << "P is before the vertex's in-edge";
  EXPECT_TRUE(in_tangent_set({{1, 0}, Summand::Q}, convex)) << "Q is after it";
  EXPECT_TRUE(in_tangent_set({{0, 1}, Summand::P}, convex)) << "P is before its out-edge";
  EXPECT_FALSE(in_tangent_set({{0, 1}, Summand::Q}, convex)) << "Q is after it";
}

/// A chain turns once around, counterclockwise (+1) or clockwise (-1), plus 2π for each reflex
/// vertex, whose tangent set goes the long way.
TEST(TangentSet, of_a_simple_chain_cover_each_direction_once_and_once_more_per_reflex_vertex) {
  for (const Shape& shape : shapes()) {
    for (const Chain& chain : chains(shape.region)) {
      int expected = sign(twice_area(chain));
      for (std::size_t i = 0; i < chain.size(); ++i)
        if (is_reflex(corner_at(chain, i))) ++expected;
      for (int x = -2; x <= 2; ++x) {
        for (int y = -2; y <= 2; ++y) {
          if (x == 0 && y == 0) continue;
          for (const Summand of : {Summand::P, Summand::Q}) {
            int covered = 0;
            for (std::size_t i = 0; i < chain.size(); ++i)
              if (in_tangent_set({{x, y}, of}, corner_at(chain, i))) ++covered;
            ASSERT_EQ(covered, expected) << shape.name << ' ' << x << ' ' << y;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace oplus
