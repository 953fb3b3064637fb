// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle/oracle.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"
#include "tests/reference/io/published_data.hpp"

namespace oplus {
namespace {

TEST(Oracle, of_two_squares_is_the_square) {
  const OracleSums sums = oracle_sums(polygon(box(0, 0, 1, 1)), polygon(box(-1, 0, 1, 2)));
  EXPECT_EQ(sums.closed, canonical_sum(polygon(box(-1, 0, 2, 3))));
  EXPECT_EQ(sums.open, sums.closed);
}

TEST(Oracle, of_the_pair_on_which_cgal_crashes_has_area_75_halves_and_no_hole) {
  const Region p = polygon({{4, 2}, {3, 1}, {1, 2}, {3, 4}, {0, 2}, {4, 0}});
  const Region q = polygon({{2, 4}, {2, 3}, {0, 0}, {2, 2}, {4, 1}, {4, 2}});
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const PlanarSet sum = oracle_sum(p, q, boundary);
    EXPECT_EQ(area(sum), Rational(75, 2));
    EXPECT_EQ(sum.outer.size(), 1u);
    EXPECT_TRUE(sum.holes.empty());
  }
}

TEST(Oracle, with_the_empty_region_is_empty) {
  const Region square = polygon(box(0, 0, 1, 1));
  for (const auto& [p, q] :
       {std::pair(Region{}, square), {square, Region{}}, {Region{}, Region{}}}) {
    const OracleSums sums = oracle_sums(p, q);
    EXPECT_EQ(sums.closed, PlanarSet{});
    EXPECT_EQ(sums.open, PlanarSet{});
  }
}

TEST(Oracle, boundary_says_which_of_the_two_sums) {
  const Region frame{{{box(0, 0, 4, 4), {backwards(box(1, 1, 3, 3))}}}};
  const Region square = polygon(box(0, 0, 2, 2));
  EXPECT_TRUE(oracle_sum(frame, square, Boundary::closed).isolated_vertices.empty());
  EXPECT_EQ(oracle_sum(frame, square, Boundary::open).isolated_vertices,
            (std::vector<Point>{{3, 3}}));
}

TEST(Oracle, of_the_published_pair_has_one_isolated_vertex_where_open) {
  const OracleSums sums =
      oracle_sums(published("isolated_vertex_part1"), published("isolated_vertex_part2"));
  EXPECT_EQ(sums.open.isolated_vertices, (std::vector<Point>{{3, 3}}));
  EXPECT_TRUE(sums.closed.isolated_vertices.empty());
}

TEST(Oracle, of_published_touching_chains_has_four_isolated_vertices_where_open) {
  const Region region = published("pwh5");
  EXPECT_EQ(oracle_sum(region, region, Boundary::open).isolated_vertices,
            (std::vector<Point>{{4, 4}, {4, 12}, {12, 4}, {12, 12}}));
}

}  // namespace
}  // namespace oplus
