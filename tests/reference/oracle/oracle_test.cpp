// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "checked/operations/image.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/difference.hpp"
#include "tests/reference/definitions/cells.hpp"
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
    const MinkowskiSum sum = oracle_sum(p, q, boundary);
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
    EXPECT_EQ(sums.closed, MinkowskiSum{});
    EXPECT_EQ(sums.open, MinkowskiSum{});
  }
}

TEST(Oracle, decides_every_cell_of_the_arrangement) {
  // The convolution of two squares runs once around their sum, with a vertex inside each side.
  const CellCount cells = oracle_sums(polygon(box(0, 0, 1, 1)), polygon(box(0, 0, 1, 1))).cells;
  EXPECT_EQ(cells.faces, 2u);
  EXPECT_EQ(cells.edges, 8u);
  EXPECT_EQ(cells.vertices, 8u);
}

TEST(Oracle, boundary_says_which_of_the_two_sums) {
  const Region frame{{{box(0, 0, 4, 4), {backwards(box(1, 1, 3, 3))}}}};
  const Region square = polygon(box(0, 0, 2, 2));
  EXPECT_TRUE(oracle_sum(frame, square, Boundary::closed).isolated_vertices.empty());
  EXPECT_EQ(oracle_sum(frame, square, Boundary::open).isolated_vertices,
            (std::vector<Point>{{3, 3}}));
}

/// All edges of a sum of doubled shapes lie on x = 2i, y = 2i and x ± y = 2i, so each of its faces,
/// edges and vertices contains a half-integer point, and at such points shared cells tell whether
/// the interiors meet: no arrangement and no orientation is needed.
TEST(Oracle, of_doubled_shapes_is_where_their_interiors_share_a_cell) {
  std::size_t on_features = 0;
  const std::vector<Shape> all = shapes();
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a; b < all.size(); b += 3) {
      const Region p = image(scaling(2), all[a].region);
      const Region q = image(scaling(2), all[b].region);
      Rational end = 1;
      for (const Region* region : {&p, &q})
        for (const Segment& e : edges(*region)) end = std::max({end, e.source.x, e.source.y});
      if (end > 8) continue;
      const auto [closed, open, cells] = oracle_sums(p, q);
      const std::set<Cell> in_p = cells_of(p);
      const std::set<Cell> in_minus_q = cells_of(reflected(q));
      for (int i = -1; i <= 33; ++i) {
        for (int j = -1; j <= 33; ++j) {
          const Point x{Rational(i) / 2, Rational(j) / 2};
          const bool meet = share_a_cell(in_p, in_minus_q, i, j);
          const Location where = locate(x, open);
          ASSERT_EQ(where == Location::inside, meet)
              << all[a].name << " + " << all[b].name << " at " << testing::PrintToString(x);
          if (where == Location::boundary && locate(x, closed) == Location::inside) ++on_features;
          // One of the triangles into which those lines cut the plane has x as an inner point.
          if ((i % 4 + 4) % 4 == 2 && (j % 2 + 2) % 2 == 1) {
            ASSERT_EQ(locate(x, closed), meet ? Location::inside : Location::outside)
                << all[a].name << " + " << all[b].name << " at " << testing::PrintToString(x);
          }
        }
      }
    }
  }
  EXPECT_GT(on_features, 20u) << "no low-dimensional features: half of the test is idle";
}

TEST(Oracle, of_the_published_pair_has_one_isolated_vertex_where_open) {
  const OracleSums sums =
      oracle_sums(published("isolated_vertex_part1"), published("isolated_vertex_part2"));
  EXPECT_EQ(sums.open.isolated_vertices, (std::vector<Point>{{3, 3}}));
  EXPECT_TRUE(sums.closed.isolated_vertices.empty());
}

TEST(Oracle, of_the_published_letters_is_the_sum_of_their_boxes) {
  // An E lying on its back and a G, as unions of unit squares: two of these sum to a square of
  // side 2, so the sum's area is the number of unit squares these cover.
  const Region e = published("E");
  const Region g = published("G");
  std::set<std::pair<int, int>> covered;
  for (int i = 5; i < 8; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 18; k < 20; ++k)
        for (int l = 0; l < 2; ++l) {
          const Rational half(1, 2);
          if (!is_inside({i + half, j + half}, edges(e)) ||
              !is_inside({k + half, l + half}, edges(g)))
            continue;
          for (int x : {0, 1})
            for (int y : {0, 1}) covered.insert({i + k + x, j + l + y});
        }
  const OracleSums sums = oracle_sums(e, g);
  EXPECT_EQ(area(sums.closed), static_cast<int>(covered.size()));
  for (int i = 20; i < 30; ++i)
    for (int j = -2; j < 7; ++j)
      EXPECT_EQ(locate({i + Rational(1, 2), j + Rational(1, 2)}, sums.closed) == Location::inside,
                covered.contains({i, j}))
          << i << ' ' << j;
}

TEST(Oracle, of_published_touching_chains_has_four_isolated_vertices_where_open) {
  const Region region = published("pwh5");
  EXPECT_EQ(oracle_sum(region, region, Boundary::open).isolated_vertices,
            (std::vector<Point>{{4, 4}, {4, 12}, {12, 4}, {12, 12}}));
}

}  // namespace
}  // namespace oplus
