// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/piece_sums.hpp"

#include <gtest/gtest.h>

#include "reference/families/family.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::certificates {
namespace {

TEST(PieceSums, sides_of_a_square_and_a_triangle) {
  const ConvexPieces p =
      pieces::convex_pieces(polygon(box(0, 0, Rational(1, 2), Rational(1, 2))), 8);
  const ConvexPieces q = pieces::convex_pieces(polygon({{0, 0}, {1, 0}, {0, 1}}), 8);
  PieceSums sums(p, q, {}, 0);
  std::vector<std::string> lines;
  for (std::size_t side = 0; side < 7; ++side) {
    const auto& [a, b, c] = sums.exact_side({0, 0}, side);
    lines.push_back(a.get_str() + " " + b.get_str() + " " + c.get_str());
  }
  std::ranges::sort(lines);
  EXPECT_EQ(lines, (std::vector<std::string>{"-1 -1 2", "-2 0 3", "0 -2 3", "0 1 0", "0 1 0",
                                             "1 0 0", "1 0 0"}));
}

/// They are off by much less than what decides.
TEST(PieceSums, doubles_are_near_to_the_exact_sides) {
  const auto [p, q] = generate(*find_family("star"), 20, 1);
  const ConvexPieces of_p = pieces::convex_pieces(p, 8), of_q = pieces::convex_pieces(q, 8);
  PieceSums sums(of_p, of_q, {}, 0);
  std::vector<HalfPlane> sides;
  for (std::uint32_t i = 0; i < of_p.pieces.size(); ++i) {
    sums.sides({i, 0}, sides);
    ASSERT_EQ(sides.size(), of_p.pieces[i].size() + of_q.pieces[0].size());
    for (std::size_t side = 0; side < sides.size(); ++side) {
      const auto& [a, b, c] = sums.exact_side({i, 0}, side);
      const double length = std::hypot(a.get_d(), b.get_d());
      EXPECT_NEAR(sides[side].a, a.get_d() / length, 1e-15);
      EXPECT_NEAR(sides[side].b, b.get_d() / length, 1e-15);
      EXPECT_NEAR(sides[side].low, -c.get_d() / length, 1e-8);
    }
  }
}

TEST(PieceSums, pairs_in_boxes_around_a_place_are_all_that_contain_it) {
  const auto [p, q] = generate(*find_family("simple"), 40, 1);
  const ConvexPieces of_p = pieces::convex_pieces(p, 8), of_q = pieces::convex_pieces(q, 8);
  const PieceSums sums(of_p, of_q, {}, 0);
  std::vector<HalfPlane> sides;
  std::size_t containing = 0;
  for (const Point& a : of_p.vertices) {
    const Place x{a.x.get_d() + of_q.vertices[0].x.get_d(),
                  a.y.get_d() + of_q.vertices[0].y.get_d()};
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    sums.for_each_box_around(x, 0, [&](const PieceSums::Pair& pair) {
      EXPECT_TRUE(found.emplace(pair.i, pair.j).second);
      return true;
    });
    for (std::uint32_t i = 0; i < of_p.pieces.size(); ++i) {
      for (std::uint32_t j = 0; j < of_q.pieces.size(); ++j) {
        sums.sides({i, j}, sides);
        if (!std::ranges::all_of(sides, [&](const HalfPlane& side) { return side.above(x) > 0; }))
          continue;
        ++containing;
        EXPECT_TRUE(found.contains({i, j}));
      }
    }
    EXPECT_LT(found.size(), of_p.pieces.size() * of_q.pieces.size());
  }
  EXPECT_GT(containing, 100U);
}

/// Triangles between a point and some of many others on a line: boxes around most of their sums contain most places.
TEST(PieceSums, few_of_many_pairs_are_found_everywhere) {
  Chain chain;
  for (int x = 0; x < 600; ++x) chain.push_back({x, 0});
  chain.push_back({300, 1});
  const ConvexPieces pieces = pieces::convex_pieces(polygon(chain), 8);
  const PieceSums sums(pieces, pieces, {}, 1200);
  std::vector<HalfPlane> sides;
  for (int x = 10; x < 1190; x += 17) {
    for (const double y : {1e-6, 1e-3, 0.01}) {
      const Place place{static_cast<double>(x), y};
      const std::vector<PieceSums::Pair> all = sums.pairs_around(place);
      const std::vector<PieceSums::Pair> few = sums.pairs_around(place, 20);
      EXPECT_FALSE(few.empty());
      EXPECT_LE(few.size(), std::min<std::size_t>(36, 2 * all.size()));
      for (const PieceSums::Pair& pair : few) EXPECT_NE(std::ranges::find(all, pair), all.end());
    }
  }
}

}  // namespace
}  // namespace oplus::certificates
