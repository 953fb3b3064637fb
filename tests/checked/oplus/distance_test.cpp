// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion frame =
    polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}},
            {{{2, 2}, {2, 4}, {4, 4}, {4, 2}}, {{5, 5}, {5, 8}, {8, 8}, {8, 5}}});
const ValidRegion square = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}});

ValidRegion moved(const ValidRegion& region, const Coordinates& by) {
  return transformed(region, translation(by));
}

/// In steps of a half: each kind of place is among them, the exact fit at (2, 2) as well.
TEST(Placements, answer_as_the_functions_do_at_each_place) {
  const Placements placements(frame, square);
  EXPECT_EQ(placements.no_fit(), nfp(frame, square));
  int counts[3] = {};
  for (int i = -8; i <= 22; ++i)
    for (int j = -8; j <= 22; ++j) {
      const Point x{Rational(i, 2), Rational(j, 2)};
      const ValidRegion q = moved(square, x);
      const NearestPoints nearest = distance(frame, q), of_place = placements.distance(x);
      EXPECT_EQ(of_place.squared_distance, nearest.squared_distance) << i << ' ' << j;
      EXPECT_TRUE(contains(frame, of_place.on_p) && contains(q, of_place.on_q)) << i << ' ' << j;
      const Vector apart{of_place.on_p.x - of_place.on_q.x, of_place.on_p.y - of_place.on_q.y};
      EXPECT_EQ(apart.x * apart.x + apart.y * apart.y, nearest.squared_distance);
      const std::optional<Overlap> way_out = depth(frame, q), from_place = placements.depth(x);
      const Location location = placements.locate(x);
      EXPECT_EQ(way_out.has_value(), location == Location::inside) << i << ' ' << j;
      EXPECT_EQ(from_place.has_value(), way_out.has_value()) << i << ' ' << j;
      EXPECT_EQ(from_place ? from_place->squared_depth : -1, way_out ? way_out->squared_depth : -1);
      EXPECT_EQ(location == Location::outside, nearest.squared_distance > 0) << i << ' ' << j;
      ++counts[static_cast<int>(location)];
    }
  for (const int count : counts) EXPECT_GT(count, 20);
}

TEST(Depth, leads_to_an_exact_fit) {
  const std::optional<Overlap> overlap = depth(frame, moved(square, {"2.25", 2}));
  ASSERT_TRUE(overlap);
  EXPECT_EQ(overlap->move, (Vector{Rational(-1, 4), 0}));
}

TEST(Distance, needs_points) {
  EXPECT_THROW(distance(frame, {}), InvalidInput);
  EXPECT_THROW(Placements({}, frame), InvalidInput);
  EXPECT_FALSE(depth(frame, {}));
  EXPECT_FALSE(depth({}, frame));
  EXPECT_FALSE(depth(complement(frame), square));
}

TEST(Distance, from_the_plane_is_zero_and_no_move_leads_out_of_it) {
  const ValidRegion plane = complement(ValidRegion());
  for (const ValidRegion& other : {square, complement(square), plane}) {
    EXPECT_EQ(distance(plane, other).squared_distance, 0);
    EXPECT_EQ(distance(other, plane).squared_distance, 0);
    EXPECT_THROW(depth(plane, other), InvalidInput);
    EXPECT_THROW(depth(other, plane), InvalidInput);
  }
}

TEST(Depth, is_none_where_no_move_is_long_enough) {
  EXPECT_THROW(depth(complement(square), frame), InvalidInput);
  EXPECT_THROW(depth(frame, complement(square)), InvalidInput);
  EXPECT_THROW(depth(complement(square), complement(frame)), InvalidInput);
  const Placements placements(complement(square), frame);
  EXPECT_EQ(placements.locate({5, 5}), Location::inside);
  EXPECT_THROW(placements.depth({5, 5}), InvalidInput);
  EXPECT_EQ(placements.distance({5, 5}).squared_distance, 0);
}

}  // namespace
}  // namespace oplus
