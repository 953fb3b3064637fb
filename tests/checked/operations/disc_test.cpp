// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/disc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/io/power_of_ten.hpp"

namespace oplus {
namespace {

constexpr std::size_t million = 1000000;

TEST(ShortStep, is_1_2_or_5_times_a_power_of_ten) {
  const std::pair<Rational, Rational> cases[] = {{1, 1},
                                                 {Rational(19, 10), 1},
                                                 {2, 2},
                                                 {4, 2},
                                                 {5, 5},
                                                 {Rational(99, 10), 5},
                                                 {10, 10},
                                                 {12345, 10000},
                                                 {Rational(1, 3), Rational(1, 5)},
                                                 {Rational(1, 5), Rational(1, 5)},
                                                 {Rational(1, 7), Rational(1, 10)},
                                                 {Rational(1, 1001), Rational(1, 2000)}};
  for (const auto& [x, step] : cases) EXPECT_EQ(short_step(x), step) << x;
}

TEST(BetweenDiscs, takes_convex_polygons_around_the_hole_of_the_ring_only) {
  const Chain square = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const Rational half_diagonal(70710678, 100000000);
  EXPECT_TRUE(is_between_discs(square, half_diagonal, 1));
  EXPECT_TRUE(is_between_discs(square, 0, 2));
  EXPECT_FALSE(is_between_discs(square, half_diagonal + Rational(1, 100000000), 1));
  EXPECT_FALSE(is_between_discs(square, half_diagonal, Rational(999, 1000)));
  EXPECT_FALSE(is_between_discs({square.rbegin(), square.rend()}, 0, 1)) << "clockwise";
  EXPECT_FALSE(is_between_discs(translated(square, {3, 0}), 0, 9)) << "beside the origin";
  EXPECT_FALSE(is_between_discs(translated(square, {1, 0}), 0, 9)) << "through the origin";
  Chain twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  EXPECT_FALSE(is_between_discs(twice, 0, 1));
  EXPECT_FALSE(is_between_discs({{2, 0}, {Rational(1, 2), Rational(1, 2)}, {0, 2}, {-2, -2}}, 0, 3))
      << "reflex";
  EXPECT_FALSE(is_between_discs({{2, 0}, {1, 1}, {0, 2}, {-2, -2}}, 0, 3)) << "collinear";
  EXPECT_FALSE(is_between_discs({}, 0, 1));
}

/// The least number of vertices between these discs, rounded up to a multiple of four.
double least(double inner, double outer) {
  return 4 * std::ceil(std::numbers::pi / std::acos(inner / outer) / 4 - 1e-9);
}

TEST(PolygonBetweenDiscs, is_between_them_and_has_few_vertices_with_short_coordinates) {
  for (const Rational& radius : {Rational(1), Rational(22, 7), Rational(1000)}) {
    for (int parts = 1; parts < 3000; parts += 1 + parts / 5) {
      const Rational error = radius / parts;
      for (const auto& [inner, outer] : {std::pair<Rational, Rational>{radius - error, radius},
                                         std::pair<Rational, Rational>{radius, radius + error}}) {
        const std::optional<Chain> chain = polygon_between_discs(inner, outer, million);
        ASSERT_TRUE(chain);
        EXPECT_TRUE(is_between_discs(*chain, inner, outer)) << inner << " " << outer;
        EXPECT_LE(static_cast<double>(chain->size()), 1.1 * least(inner.get_d(), outer.get_d()) + 4)
            << inner << " " << outer;
        const Rational step = short_step(error / 10);
        for (const Point& p : *chain) {
          EXPECT_EQ(Rational(p.x / step).get_den(), 1);
          EXPECT_EQ(Rational(p.y / step).get_den(), 1);
        }
      }
    }
  }
}

TEST(PolygonBetweenDiscs, has_the_symmetries_of_a_square) {
  for (const int parts : {2, 10, 55, 1234}) {
    const Chain chain = *polygon_between_discs(1 - Rational(1, parts), 1, million);
    EXPECT_EQ(chain[0].y, 0);
    EXPECT_GT(chain[0].x, 0);
    for (const auto& map : {+[](const Point& p) {
                              return Point{-p.y, p.x};
                            },
                            +[](const Point& p) {
                              return Point{p.x, -p.y};
                            },
                            +[](const Point& p) {
                              return Point{p.y, p.x};
                            }}) {
      Chain image = chain, sorted = chain;
      std::transform(image.begin(), image.end(), image.begin(), map);
      std::sort(image.begin(), image.end());
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(image, sorted);
    }
  }
}

TEST(PolygonBetweenDiscs, is_nothing_where_too_many_vertices_are_needed) {
  ASSERT_TRUE(polygon_between_discs(Rational(99, 100), 1, 24));
  EXPECT_EQ(polygon_between_discs(Rational(99, 100), 1, 24)->size(), 24U);
  EXPECT_FALSE(polygon_between_discs(Rational(99, 100), 1, 23));
  EXPECT_FALSE(polygon_between_discs(1 - Rational(1, power_of_ten(1000)), 1, million));
}

}  // namespace
}  // namespace oplus
