// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/summand_boundary.hpp"

#include <gtest/gtest.h>

#include "reference/chains/touching_points.hpp"
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
        EXPECT_EQ(boundary.pieces.at(next_piece), piece) << shape.name;
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
