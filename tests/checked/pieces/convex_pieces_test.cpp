// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/pieces/convex_pieces.hpp"

#include <gtest/gtest.h>

#include "reference/families/family.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::pieces {
namespace {

std::size_t pieces(const Region& region) { return convex_pieces(region, 8).pieces.size(); }

TEST(ConvexPieces, are_few) {
  EXPECT_EQ(pieces({}), 0U);
  EXPECT_EQ(pieces(polygon(box(0, 0, 1, 1))), 1U);
  EXPECT_EQ(pieces(polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}})), 2U);
  EXPECT_EQ(pieces(holed(box(0, 0, 3, 3), {box(1, 1, 2, 2)})), 4U);
}

/// With fractions, which doubles do not hold: the same pieces.
TEST(ConvexPieces, of_fractions_are_those_of_integers) {
  const Region region = generate(*find_family("simple"), 30, 1).p;
  const auto third = [](const Point& p) { return Point{p.x / 3, p.y / 3}; };
  EXPECT_EQ(convex_pieces(region, 8).pieces.size(),
            convex_pieces(mapped(region, third), 8).pieces.size());
}

TEST(ConvexPieces, points_of_other_chains_are_put_into_edges_in_order) {
  const Region region =
      holed(box(0, 0, 8, 8), {{{6, 0}, {7, 1}, {5, 1}}, {{2, 0}, {3, 1}, {1, 1}}});
  EXPECT_EQ(convex_pieces(region, 8).points, (std::vector<PointInEdge>{{0, {2, 0}}, {0, {6, 0}}}));
}

/// So that there is a corner to start a fan at, also in what a piece is cut into.
TEST(ConvexPieces, have_several_flat_corners_on_one_side_at_most) {
  Chain chain = box(0, 0, 6, 6);
  for (const int x : {1, 2, 3, 4, 5}) chain.insert(chain.begin() + x, Point{x, 0});
  for (const int x : {5, 4, 3, 2, 1}) chain.insert(chain.end() - 1, Point{x, 6});
  for (const Region& region : {polygon(chain), generate(*find_family("fork"), 9, 1).p,
                               generate(*find_family("maze"), 5, 1).p}) {
    const ConvexPieces all = convex_pieces(region, 10);
    for (const ConvexPiece& piece : all.pieces) {
      EXPECT_LE(piece.size(), 10U);
      std::vector<bool> is_flat;
      for (std::size_t k = 0; k < piece.size(); ++k)
        is_flat.push_back(orientation(all.vertices[piece[previous(k, piece.size())]],
                                      all.vertices[piece[k]],
                                      all.vertices[piece[next(k, piece.size())]]) == 0);
      EXPECT_FALSE(is_flat[1] || is_flat.back());
      int sides = 0;
      for (std::size_t k = 1; k + 1 < piece.size(); ++k)
        sides += !is_flat[k - 1] && is_flat[k] && is_flat[k + 1];
      EXPECT_LE(sides, 1);
    }
  }
}

/// A fan of long thin triangles would be cut into many cells each.
TEST(ConvexPieces, vertices_on_a_line_are_corners_of_one) {
  Chain chain = {{0, 0}, {100, 0}};
  for (int x = 99; x > 0; --x) chain.push_back({x, 100 - x});
  chain.push_back({0, 100});
  EXPECT_EQ(convex_pieces(polygon(chain), 200).pieces.size(), 1U);
}

}  // namespace
}  // namespace oplus::pieces
