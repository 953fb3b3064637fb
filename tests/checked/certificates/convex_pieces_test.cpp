// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/convex_pieces.hpp"

#include <gtest/gtest.h>

#include "reference/families/family.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::certificates {
namespace {

std::size_t pieces(const Region& region) { return convex_pieces(region).pieces.size(); }

TEST(ConvexPieces, are_few) {
  EXPECT_EQ(pieces({}), 0U);
  EXPECT_EQ(pieces(polygon(box(0, 0, 1, 1))), 1U);
  EXPECT_EQ(pieces(polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}})), 2U);
  EXPECT_EQ(pieces(holed(box(0, 0, 3, 3), {box(1, 1, 2, 2)})), 4U);
}

/// With fractions, where CGAL computes otherwise: the same pieces.
TEST(ConvexPieces, of_fractions_are_those_of_integers) {
  const Region region = generate(*find_family("simple"), 30, 1).p;
  const auto third = [](const Point& p) { return Point{p.x / 3, p.y / 3}; };
  EXPECT_EQ(convex_pieces(region).pieces.size(),
            convex_pieces(mapped(region, third)).pieces.size());
}

TEST(ConvexPieces, points_of_other_chains_are_put_into_edges_in_order) {
  const Region region =
      holed(box(0, 0, 8, 8), {{{6, 0}, {7, 1}, {5, 1}}, {{2, 0}, {3, 1}, {1, 1}}});
  EXPECT_EQ(convex_pieces(region).points, (std::vector<PointInEdge>{{0, {2, 0}}, {0, {6, 0}}}));
}

/// So that there is a corner to start a fan at, also in what a piece is cut into.
TEST(ConvexPieces, have_one_flat_corner_on_a_side_at_most) {
  Chain chain = box(0, 0, 6, 6);
  for (const int x : {1, 2, 3, 4, 5}) chain.insert(chain.begin() + x, Point{x, 0});
  for (const Region& region : {polygon(chain), generate(*find_family("fork"), 5, 1).p,
                               generate(*find_family("maze"), 5, 1).p}) {
    const ConvexPieces all = convex_pieces(region);
    for (const ConvexPiece& piece : all.pieces) {
      EXPECT_LE(piece.size(), 8U);
      std::vector<int> turns;
      for (std::size_t k = 0; k < piece.size(); ++k)
        turns.push_back(orientation(all.vertices[piece[previous(k, piece.size())]],
                                    all.vertices[piece[k]],
                                    all.vertices[piece[next(k, piece.size())]]));
      for (std::size_t k = 0; k < piece.size(); ++k)
        EXPECT_GT(turns[k] + turns[next(k, piece.size())], 0);
    }
  }
}

}  // namespace
}  // namespace oplus::certificates
