// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/summand_boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/chains/touching_points.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/families/family.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Region frame{{{box(0, 0, 6, 6), {backwards(box(2, 2, 4, 4))}}}};
const Region small = polygon(box(0, 0, 1, 1));

TEST(SummandBoundary, keeps_the_pieces_of_each_chain_together) {
  for (const Shape& shape : shapes()) {
    const SummandBoundary boundary(shape.region);
    const auto pieces = pieces_by_chain(shape.region);
    ASSERT_EQ(boundary.vertex_of_chain.size(), pieces.size()) << shape.name;
    ASSERT_EQ(boundary.chain_of.size(), boundary.pieces.size()) << shape.name;
    std::size_t next_piece = 0;
    for (std::size_t chain = 0; chain < pieces.size(); ++chain) {
      EXPECT_EQ(boundary.vertex_of_chain[chain], pieces[chain].front().source) << shape.name;
      for (const Segment& piece : pieces[chain]) {
        ASSERT_LT(next_piece, boundary.pieces.size()) << shape.name;
        EXPECT_EQ(boundary.pieces[next_piece], piece) << shape.name;
        EXPECT_EQ(boundary.chain_of.at(next_piece), chain) << shape.name;
        ++next_piece;
      }
    }
    EXPECT_EQ(next_piece, boundary.pieces.size()) << shape.name;
  }
}

TEST(SummandBoundary, of_the_empty_region_is_empty) {
  const SummandBoundary boundary{Region{}};
  EXPECT_TRUE(boundary.pieces.empty());
  EXPECT_TRUE(boundary.vertex_of_chain.empty());
}

/// Whether the boundary runs through a point.
bool is_on_an_edge(const Point& x, const Region& region) {
  const std::vector<Segment> all = edges(region);
  return std::any_of(all.begin(), all.end(), [&](const Segment& e) { return lies_on(x, e); });
}

TEST(SummandBoundary, contains_what_the_chains_wind_around) {
  Random random(4);
  std::size_t inside = 0, outside = 0;
  const auto expect_as_defined = [&](const Region& region, const SummandBoundary& boundary,
                                     const Point& x) {
    if (is_on_an_edge(x, region)) return;
    const bool expected = winding_number(x, edges(region)) > 0;
    ++(expected ? inside : outside);
    EXPECT_EQ(boundary.contains(x), expected)
        << testing::PrintToString(region) << testing::PrintToString(x);
  };
  for (const Family& family : families()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Summands pair = generate(family, 6, seed);
      for (const Region* region : {&pair.p, &pair.q}) {
        const SummandBoundary boundary(*region);
        const std::vector<Segment> all = edges(*region);
        // Level with vertices, and between two.
        for (int k = 0; k < 40; ++k) {
          const Point& a = all[uniform_index(random, all.size())].source;
          const Point& b = all[uniform_index(random, all.size())].source;
          expect_as_defined(*region, boundary, {a.x, b.y});
          expect_as_defined(*region, boundary, {(a.x + b.x) / 2, a.y});
          expect_as_defined(*region, boundary, midpoint(a, b));
        }
      }
    }
  }
  EXPECT_GT(inside, 500u);
  EXPECT_GT(outside, 500u);
}

TEST(SummandBoundary, tells_chains_apart_that_touch_level_with_a_point) {
  // To the right of (1, 3): a hole that touches the outer chain in a vertex, and the corner of another.
  const Region region{{{{{0, 0}, {9, 0}, {6, 3}, {9, 6}, {0, 6}},
                        {{{6, 3}, {4, 2}, {4, 4}}, {{3, 3}, {2, 2}, {2, 3}}}}}};
  const SummandBoundary boundary(region);
  const Rational little(1, 1000000);
  for (const Rational& y : {Rational(3), Rational(3 + little), Rational(3 - little)}) {
    EXPECT_TRUE(boundary.contains({1, y}));
    EXPECT_TRUE(boundary.contains({Rational(7, 2), y}));
    EXPECT_FALSE(boundary.contains({5, y}));
    EXPECT_FALSE(boundary.contains({-1, y}));
    EXPECT_FALSE(boundary.contains({7, y}));
  }
}

TEST(UntouchedChains, inside_the_other_region_are_seen_either_way_round) {
  const SummandBoundary big(frame);
  const SummandBoundary little(small);
  const TouchedChains none = untouched(big, little);
  EXPECT_TRUE(one_contains_untouched_chain(big, little, {Rational(1, 2), 3}, none));
  EXPECT_FALSE(one_contains_untouched_chain(big, little, {Rational(5, 2), 3}, none)) << "in a hole";
  EXPECT_FALSE(one_contains_untouched_chain(big, little, {7, 0}, none)) << "outside";
  const TouchedChains exchanged = untouched(little, big);
  EXPECT_TRUE(one_contains_untouched_chain(little, big, {Rational(-1, 2), -3}, exchanged));
  EXPECT_FALSE(one_contains_untouched_chain(little, big, {Rational(-5, 2), -3}, exchanged));
}

TEST(UntouchedChains, are_the_only_ones_that_count) {
  const SummandBoundary two({{{box(0, 0, 1, 1), {}}, {box(3, 3, 4, 4), {}}}});
  const SummandBoundary around(polygon(box(-1, -1, 2, 2)));
  TouchedChains touched = untouched(two, around);
  EXPECT_TRUE(one_contains_untouched_chain(two, around, {0, 0}, touched));
  touched[0][1] = true;
  EXPECT_TRUE(one_contains_untouched_chain(two, around, {0, 0}, touched));
  touched[0][0] = true;
  EXPECT_FALSE(one_contains_untouched_chain(two, around, {0, 0}, touched));
}

}  // namespace
}  // namespace oplus
