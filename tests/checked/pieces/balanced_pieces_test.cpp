// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/pieces/balanced_pieces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reference/definitions/region.hpp"
#include "reference/definitions/values.hpp"

namespace oplus::pieces {
namespace {

struct Divided {
  Chain ring;
  std::vector<ConvexPiece> pieces;
};

Divided divided(Chain chain, std::uint32_t most_corners) {
  ConvexRing ring;
  std::vector<Place> places;
  for (std::uint32_t k = 0; k < chain.size(); ++k) {
    ring.corners.push_back(k);
    ring.is_flat.push_back(
        orientation(chain[previous(k, chain.size())], chain[k], chain[next(k, chain.size())]) == 0);
    places.push_back({chain[k].x.get_d(), chain[k].y.get_d()});
  }
  Divided result{std::move(chain), {}};
  add_balanced_pieces(std::move(ring), most_corners, places, result.pieces);
  return result;
}

/// Convex pieces that cover the ring once, each with a fan of triangles: the checker asks the same of them.
void expect_divides(const Divided& of, std::uint32_t most_corners) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ConvexPiece& piece : of.pieces) {
    const std::size_t size = piece.size();
    ASSERT_LE(size, most_corners);
    for (std::size_t k = 0; k < size; ++k) {
      EXPECT_TRUE(edges.emplace(piece[k], piece[next(k, size)]).second);
      EXPECT_GE(orientation(of.ring[piece[k]], of.ring[piece[next(k, size)]],
                            of.ring[piece[next(next(k, size), size)]]),
                0);
      if (k > 0 && k + 1 < size) {
        EXPECT_GT(orientation(of.ring[piece[0]], of.ring[piece[k]], of.ring[piece[k + 1]]), 0);
      }
    }
  }
  const auto size = static_cast<std::uint32_t>(of.ring.size());
  for (std::uint32_t k = 0; k < size; ++k) EXPECT_EQ(edges.erase({k, (k + 1) % size}), 1U);
  for (const auto& [from, to] : edges) EXPECT_TRUE(edges.contains({to, from}));
}

Chain parabola(int size) {
  Chain chain;
  for (int x = 0; x < size; ++x) chain.push_back({x, x * x});
  return chain;
}

/// A parabola on the long side of a triangle that has many vertices, or few.
Chain on_a_line(int size, int step) {
  Chain chain = parabola(size);
  for (int x = size - 1 - step; x > 0; x -= step) chain.push_back({x, x * (size - 1)});
  return chain;
}

/// A parabola to the right of a vertical side that has many vertices.
Chain on_a_wall(int size) {
  Chain chain;
  for (int y = 0; y < size; ++y) chain.push_back({y * (size - 1 - y), y});
  for (int y = size - 2; y > 0; --y) chain.push_back({0, y});
  return chain;
}

/// Between two parabolas, twice as wide as high.
Chain lens(int size) {
  Chain chain;
  for (int x = 0; x < size; ++x) chain.push_back({x * size, x * (x - size)});
  for (int x = size; x > 0; --x) chain.push_back({x * size, x * (size - x)});
  return chain;
}

TEST(BalancedPieces, divide_polygons_of_any_size) {
  for (const std::uint32_t most : {3U, 4U, 8U, 256U})
    for (int size = 3; size < 60; ++size) expect_divides(divided(parabola(size), most), most);
  expect_divides(divided(parabola(999), 8), 8);
  expect_divides(divided(lens(500), 8), 8);
}

TEST(BalancedPieces, divide_what_has_flat_corners) {
  for (const std::uint32_t most : {3U, 4U, 8U})
    for (int size = 3; size < 60; ++size)
      for (const int step : {1, 3, 7, 20})
        expect_divides(divided(on_a_line(size, step), most), most);
  for (int size = 4; size < 30; ++size) expect_divides(divided(on_a_wall(size), 8), 8);
}

TEST(BalancedPieces, are_as_few_as_there_can_be) {
  EXPECT_EQ(divided(parabola(8), 8).pieces.size(), 1U);
  EXPECT_EQ(divided(parabola(9), 8).pieces.size(), 2U);
  EXPECT_EQ(divided(parabola(602), 8).pieces.size(), 100U);
  EXPECT_EQ(divided(parabola(603), 8).pieces.size(), 101U);
  EXPECT_EQ(divided(on_a_line(302, 1), 8).pieces.size(), 100U);
}

/// Boxes around what is in one of eight slabs reach a little beyond the polygon only.
TEST(BalancedPieces, are_in_slabs) {
  const Divided all = divided(lens(1000), 8);
  for (const ConvexPiece& piece : all.pieces) {
    const auto [low, high] =
        std::ranges::minmax(piece, {}, [&](std::uint32_t k) { return all.ring[k].x; });
    EXPECT_LT(all.ring[high].x - all.ring[low].x, 1000 * 1000 / 6);
  }
}

}  // namespace
}  // namespace oplus::pieces
