// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/pieces_on_lines.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "reference/families/random.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers>
class PiecesOnLinesIn : public testing::Test {};
TYPED_TEST_SUITE(PiecesOnLinesIn, AllNumbers);

// All segments of two triangles are along their sides, from (0, 0) to (8, 0) and so on.
const Region large = polygon({{0, 0}, {8, 0}, {0, 8}});
const Region small = polygon({{0, 0}, {2, 0}, {0, 2}});

template <typename Numbers>
struct Both {
  Both() : scaling(scaling_of(large, small)), tracks(large, small, scaling) {}

  Segment in_the_plane(const FreePiece<Numbers>& piece) const {
    const auto point = [&](const Fraction<Numbers>& t) {
      return ExactPoint<Numbers>(tracks[piece.segment].exact, t).in_the_plane(scaling);
    };
    return {point(piece.piece.from), point(piece.piece.to)};
  }
  std::vector<Segment> in_the_plane(const std::vector<FreePiece<Numbers>>& pieces) const {
    std::vector<Segment> segments;
    for (const auto& piece : pieces) segments.push_back(in_the_plane(piece));
    return segments;
  }

  Scaling scaling;
  Tracks<Numbers> tracks;
};

TYPED_TEST(PiecesOnLinesIn, have_the_union_of_a_cover_that_is_at_most_double) {
  const Both<TypeParam> both;
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    std::vector<FreePiece<TypeParam>> pieces;
    const int count = uniform(random, 0, 12);
    while (pieces.size() < static_cast<std::size_t>(count)) {
      const auto segment =
          static_cast<std::uint32_t>(uniform(random, 0, static_cast<int>(both.tracks.size()) - 1));
      if (!is_to_the_right(both.tracks.direction(segment))) continue;
      const int d = uniform(random, 1, 12), from = uniform(random, 0, d - 1);
      pieces.push_back(
          {segment,
           {fraction<TypeParam>(from, d), fraction<TypeParam>(uniform(random, from + 1, d), d)}});
    }
    const PiecesOnLines<TypeParam> on_lines(both.tracks, pieces, both.tracks.summands().margins);
    const std::vector<Segment> chosen = both.in_the_plane(on_lines.cover());
    const std::vector<Segment> expected = maximal_segments(both.in_the_plane(pieces));
    EXPECT_EQ(maximal_segments(chosen), expected);
    for (std::size_t a = 0; a < chosen.size(); ++a)
      for (std::size_t b = a + 1; b < chosen.size(); ++b)
        for (std::size_t c = b + 1; c < chosen.size(); ++c)
          EXPECT_FALSE(overlap(chosen[a], chosen[b]) && overlap(chosen[a], chosen[c]) &&
                       overlap(chosen[b], chosen[c]));
    std::vector<Segment> connected;
    on_lines.each_connected([&](const auto& first, const auto& last) {
      connected.push_back({both.in_the_plane(first).source, both.in_the_plane(last).target});
    });
    std::sort(connected.begin(), connected.end());
    EXPECT_EQ(connected, expected);
  }
}

}  // namespace
}  // namespace oplus::slide
