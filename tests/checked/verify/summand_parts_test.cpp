// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/summand_parts.hpp"

#include <gtest/gtest.h>

#include "reference/families/family.hpp"
#include "reference/families/polygons.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::convex_parts {
namespace {

Chain chain_of(const SummandParts& parts, const Piece& piece) {
  Chain chain;
  for (std::uint32_t i = 0; i < piece.count; ++i)
    chain.push_back(parts.sides[piece.first + i].start->point);
  return chain;
}

/// With holes, components, and chains that touch.
TEST(SummandParts, are_convex_and_have_the_area_of_the_region) {
  std::size_t pieces = 0, vertices = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
      const auto [p, q] = generate(family, family.smallest + 2, seed);
      for (const Region& region : {p, q}) {
        const SummandParts parts(region);
        Rational sum = 0;
        for (const Piece& piece : parts.pieces) {
          const Chain chain = chain_of(parts, piece);
          for (std::size_t i = 0; i < chain.size(); ++i) {
            const Line& line = *parts.sides[piece.first + i].line;
            const Vector along = chain[next(i, chain.size())] - chain[i];
            EXPECT_EQ(cross(line.along(), along), 0) << family.name;
            EXPECT_EQ(cross(line.along(), chain[i] - line.from->point), 0) << family.name;
            for (const Point& corner : chain) EXPECT_GE(cross(along, corner - chain[i]), 0);
          }
          sum += twice_area(chain) / 2;
        }
        EXPECT_EQ(sum, area(region)) << family.name << " " << seed;
        pieces += parts.pieces.size();
        vertices += vertex_count(region);
      }
    }
  }
  EXPECT_LT(2 * pieces, vertices);
}

TEST(SummandParts, a_convex_polygon_is_one) {
  Random random(1);
  EXPECT_EQ(SummandParts(convex_polygon(random, 200)).pieces.size(), 1U);
  // Also where vertices are one above the other, or inside an edge.
  EXPECT_EQ(
      SummandParts(polygon({{0, 0}, {1, -1}, {2, -1}, {4, 0}, {4, 1}, {2, 2}, {1, 2}, {0, 1}}))
          .pieces.size(),
      1U);
}

TEST(SummandParts, end_at_reflex_vertices) {
  const Chain l = {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {0, 2}};
  EXPECT_EQ(SummandParts(polygon(l)).pieces.size(), 2U);
  EXPECT_EQ(SummandParts(holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)})).pieces.size(), 4U);
}

}  // namespace
}  // namespace oplus::convex_parts
