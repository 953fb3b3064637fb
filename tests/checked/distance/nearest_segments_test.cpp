// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/distance/nearest_segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "reference/definitions/squared_distance.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

/// Segments and points, in a square of that width; their coordinates are whole numbers times `unit`.
std::vector<Segment> segments_in(int width, const Rational& unit, const Vector& by, unsigned seed) {
  const auto number = [&] {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<int>((seed >> 8) % static_cast<unsigned>(width));
  };
  std::vector<Segment> all;
  while (all.size() < 12) {
    const Point a{number(), number()}, b{number(), number()};
    all.push_back({by + unit * a, by + unit * (all.size() % 4 == 0 ? a : b)});
  }
  return all;
}

/// By the definition: of segments that have no point in common, an end of one is nearest to the other.
Rational squared_distance_of_all(const std::vector<Segment>& p, const std::vector<Segment>& q) {
  Rational least = squared_length(p[0].source - q[0].source);
  for (const Segment& a : p)
    for (const Segment& b : q) {
      if (!intersection(a, b).empty()) return 0;
      for (const auto& [end, other] :
           {std::pair(a.source, b), {a.target, b}, {b.source, a}, {b.target, a}})
        least = std::min(least, squared_distance(end, other));
    }
  return least;
}

TEST(NearestSegments, are_those_that_a_look_at_all_pairs_finds) {
  std::size_t meet = 0, far = 0;
  const Rational third(1, 3);
  // Doubles tell nothing apart where all is 2^-40 wide around 10^15.
  const Rational small(1, mpz_class(1) << 40);
  const Rational large("1000000000000001");
  for (unsigned seed = 1; seed <= 40; ++seed)
    for (const auto& [unit, at] :
         {std::pair<Rational, Vector>(1, {0, 0}), {third, {7, third}}, {small, {large, -large}}}) {
      const std::vector<Segment> p = segments_in(9, unit, at, seed);
      for (const int gap : {0, 9, 12}) {
        const std::vector<Segment> q =
            segments_in(9, unit, at + Vector{gap * unit, gap * unit / 4}, 1000 + seed);
        const auto [squared, on_p, on_q] = nearest_points(SegmentTree(p), SegmentTree(q));
        EXPECT_EQ(squared, squared_distance_of_all(p, q)) << seed;
        EXPECT_EQ(squared_length(on_p - on_q), squared) << seed;
        EXPECT_TRUE(lies_on_one(on_p, p) && lies_on_one(on_q, q)) << seed;
        ++(sgn(squared) == 0 ? meet : far);
      }
    }
  EXPECT_GE(meet, 80U);
  EXPECT_GE(far, 200U);
}

/// Ends of others are nearer to each other than those of the two that cross.
TEST(NearestSegments, may_cross_far_from_their_ends) {
  const std::vector<Segment> p = {{{0, 30}, {1, 30}}, {{0, 0}, {20, 0}}};
  const std::vector<Segment> q = {{{0, 31}, {1, 31}}, {{10, -10}, {10, 10}}};
  for (const auto& [a, b] : {std::pair(p, q), {q, p}}) {
    const auto [squared, on_a, on_b] = nearest_points(SegmentTree(a), SegmentTree(b));
    EXPECT_EQ(squared, 0);
    EXPECT_EQ(on_a, (Point{10, 0}));
    EXPECT_EQ(on_b, on_a);
  }
}

}  // namespace
}  // namespace oplus
