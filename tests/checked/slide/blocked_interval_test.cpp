// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/blocked_interval.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/region.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus::slide {
namespace {

struct Case {
  Segment segment, of_p, of_q;
};

template <typename Numbers = SmallNumbers>
std::optional<Places> blocked(const Case& c, Shift shift) {
  return places(blocked_interval(integer_segment<Numbers>(c.segment),
                                 integer_segment<Numbers>(c.of_p), integer_segment<Numbers>(c.of_q),
                                 shift));
}

const AffineMap mirror{-1, 0, 0, 1};

Case mapped(const Case& c, const AffineMap& map) {
  return {image(map, c.segment), image(map, c.of_p), image(map, c.of_q)};
}

/// The answer for a case must be that for all it looks like: rotated, mirrored (the segment the other
/// way round, so that its right stays), the edges exchanged or directed the other way.
void expect_blocked(const Case& hand, Shift shift, const std::optional<Places>& expected) {
  Case c = hand;
  for (int turn = 0; turn < 4; ++turn) {
    for (const bool exchanged : {false, true}) {
      for (const bool p_reversed : {false, true}) {
        for (const bool q_reversed : {false, true}) {
          Case variant = c;
          if (p_reversed) variant.of_p = reversed(variant.of_p);
          if (q_reversed) variant.of_q = reversed(variant.of_q);
          if (exchanged) std::swap(variant.of_p, variant.of_q);
          const std::string what = std::to_string(turn) + (exchanged ? ", exchanged" : "") +
                                   (p_reversed ? ", P reversed" : "") +
                                   (q_reversed ? ", Q reversed" : "");
          EXPECT_EQ(blocked(variant, shift), expected) << what;
          Case mirrored = mapped(variant, mirror);
          mirrored.segment = reversed(mirrored.segment);
          EXPECT_EQ(blocked(mirrored, shift), from_the_end(expected)) << what << ", mirrored";
        }
      }
    }
    c = mapped(c, quarter_turns(1));
  }
}

constexpr Shift both[] = {Shift::none, Shift::to_the_right};

// The sum of these is the rectangle from (0, 0) to (4, 2), of the next two a parallelogram.
const Segment across{{0, 0}, {4, 0}}, up{{0, 0}, {0, 2}};
const Segment far_across{{7, -3}, {11, -3}}, far_up{{-7, 3}, {-7, 5}};
const Segment slanted{{0, 0}, {2, 2}};

TEST(BlockedInterval, is_where_the_segment_is_inside) {
  for (const Shift shift : both) {
    expect_blocked({{{-1, 1}, {9, 1}}, across, up}, shift, Places{{1, 10}, {1, 2}});
    expect_blocked({{{-1, 1}, {9, 1}}, far_across, far_up}, shift, Places{{1, 10}, {1, 2}});
    // The line counts, not only the segment.
    expect_blocked({{{1, 1}, {2, 1}}, across, up}, shift, Places{-1, 3});
    expect_blocked({{{-2, 1}, {-1, 1}}, across, up}, shift, Places{2, 6});
    // In at a side and out at the one beside it; from corner to corner.
    expect_blocked({{{-1, 0}, {3, 4}}, across, up}, shift, Places{{1, 4}, {1, 2}});
    expect_blocked({{{0, 0}, {4, 2}}, across, up}, shift, Places{0, 1});
    // The parallelogram (0, 0), (4, 0), (6, 2), (2, 2).
    expect_blocked({{{0, 1}, {8, 1}}, across, slanted}, shift, Places{{1, 8}, {5, 8}});
    expect_blocked({{{2, -1}, {2, 3}}, across, slanted}, shift, Places{{1, 4}, {3, 4}});
  }
}

TEST(BlockedInterval, is_empty_beside_the_parallelogram) {
  for (const Shift shift : both) {
    expect_blocked({{{-1, 3}, {9, 3}}, across, up}, shift, std::nullopt);
    expect_blocked({{{-1, -1}, {9, -1}}, across, up}, shift, std::nullopt);
    expect_blocked({{{-3, 0}, {3, 6}}, across, up}, shift, std::nullopt);
  }
}

TEST(BlockedInterval, along_a_side_is_blocked_where_the_inside_is_to_the_right) {
  // Along the lower side: to the right as the segment goes to the left.
  const Segment rightwards{{-2, 0}, {6, 0}}, leftwards = reversed(rightwards);
  expect_blocked({rightwards, across, up}, Shift::to_the_right, std::nullopt);
  expect_blocked({leftwards, across, up}, Shift::to_the_right, Places{{1, 4}, {3, 4}});
  // Along the upper one.
  const Segment above{{-2, 2}, {6, 2}};
  expect_blocked({above, across, up}, Shift::to_the_right, Places{{1, 4}, {3, 4}});
  expect_blocked({reversed(above), across, up}, Shift::to_the_right, std::nullopt);
  // Along the slanted sides.
  const Segment left{{-1, -1}, {3, 3}}, right{{3, -1}, {7, 3}};
  expect_blocked({left, across, slanted}, Shift::to_the_right, Places{{1, 4}, {3, 4}});
  expect_blocked({reversed(left), across, slanted}, Shift::to_the_right, std::nullopt);
  expect_blocked({right, across, slanted}, Shift::to_the_right, std::nullopt);
  expect_blocked({reversed(right), across, slanted}, Shift::to_the_right, Places{{1, 4}, {3, 4}});
}

TEST(BlockedInterval, along_a_side_is_empty_without_a_shift) {
  for (const Segment& along : {Segment{{-2, 0}, {6, 0}}, Segment{{-2, 2}, {6, 2}},
                               Segment{{0, -1}, {0, 1}}, Segment{{4, -1}, {4, 1}}}) {
    expect_blocked({along, across, up}, Shift::none, std::nullopt);
    expect_blocked({reversed(along), across, up}, Shift::none, std::nullopt);
  }
}

TEST(BlockedInterval, is_empty_where_only_a_corner_is_touched) {
  for (const Shift shift : both) {
    for (const Segment& touching : {Segment{{-1, 1}, {1, -1}}, Segment{{3, 3}, {5, 1}},
                                    Segment{{3, -1}, {5, 1}}, Segment{{-2, 1}, {2, 3}}}) {
      expect_blocked({touching, across, up}, shift, std::nullopt);
      expect_blocked({reversed(touching), across, up}, shift, std::nullopt);
    }
  }
}

TEST(BlockedInterval, of_parallel_edges_is_empty) {
  for (const Shift shift : both) {
    for (const Segment& parallel :
         {Segment{{0, 0}, {3, 0}}, Segment{{1, 5}, {2, 5}}, Segment{{3, 0}, {0, 0}}}) {
      expect_blocked({{{-9, 0}, {9, 0}}, across, parallel}, shift, std::nullopt);
      expect_blocked({{{1, -9}, {1, 9}}, across, parallel}, shift, std::nullopt);
      expect_blocked({{{1, -9}, {5, 9}}, across, parallel}, shift, std::nullopt);
    }
  }
}

TEST(BlockedInterval, of_the_pair_in_contact_is_empty) {
  // An edge of P at a convex vertex of Q, the segment (1, 1) to (5, 1): Q's interior is to the left
  // of its edges, so those that meet there leave x(t), shifted, outside.
  const Segment edge{{0, 0}, {4, 0}};
  const Segment entering{{0, 3}, {1, 1}}, leaving{{1, 1}, {3, 2}};
  const Segment slid{{1, 1}, {5, 1}};
  for (const Shift shift : both) {
    expect_blocked({slid, edge, entering}, shift, std::nullopt);
    expect_blocked({slid, edge, leaving}, shift, std::nullopt);
    expect_blocked({slid, edge, {{1, 1}, {2, 1}}}, shift, std::nullopt);
  }
}

/// Whether a place, shifted by far less than small integers can tell, is inside.
bool is_inside_by_definition(const Case& c, const Rational& t, Shift shift) {
  const Vector d = direction_of(c.segment);
  const Vector u = direction_of(c.of_p), w = direction_of(c.of_q);
  if (cross(u, w) == 0) return false;
  Point x = c.segment.source + t * d;
  if (shift == Shift::to_the_right) x = x + Rational(1, 1000000000) * Vector{d.y, -d.x};
  const Point corner = c.of_p.source + c.of_q.source;
  Chain chain{corner, corner + u, corner + u + w, corner + w};
  if (cross(u, w) < 0) std::swap(chain[1], chain[3]);
  return locate(x, polygon(chain)) == Location::inside;
}

TEST(BlockedInterval, is_that_of_the_definition) {
  Random random(11);
  std::size_t found = 0;
  for (int k = 0; k < 600; ++k) {
    const Segment of_p = random_segment(random, 3), of_q = random_segment(random, 3);
    const Point x = one_in(random, 2) ? of_p.source + of_q.target
                                      : random_point(random, 3) + random_point(random, 3);
    Vector along = one_in(random, 2) ? direction_of(of_p) : direction_of(random_segment(random, 3));
    if (one_in(random, 2)) along = -along;
    const Case c{{x, x + along}, of_p, of_q};
    for (const Shift shift : both) {
      const std::optional<Places> interval = blocked(c, shift);
      if (interval) {
        ++found;
        ASSERT_LT(interval->from, interval->to);
      }
      // No end of an interval is at such a place, as their denominators are below 101.
      for (int i = -303; i <= 404; i += 7) {
        const Rational t(i, 101);
        if (i % 101 == 0) continue;
        EXPECT_EQ(is_inside_by_definition(c, t, shift),
                  interval && interval->from < t && t < interval->to)
            << testing::PrintToString(of_p) << testing::PrintToString(of_q)
            << testing::PrintToString(c.segment) << " at " << t;
      }
    }
  }
  EXPECT_GT(found, 200u);
}

template <typename Numbers>
class BlockedIntervalAtTheLimit : public testing::Test {};
TYPED_TEST_SUITE(BlockedIntervalAtTheLimit, LimitedNumbers);

TYPED_TEST(BlockedIntervalAtTheLimit, is_that_of_gmp) {
  std::size_t found = 0;
  for_each_slid_edge_at_the_limit<TypeParam>(
      [&](const Segment& slid, const Segment& of_p, const Segment& of_q) {
        for (const Shift shift : both) {
          const auto expected = blocked<AnyNumbers>({slid, of_p, of_q}, shift);
          EXPECT_EQ(blocked<TypeParam>({slid, of_p, of_q}, shift), expected);
          found += expected ? 1 : 0;
        }
      });
  EXPECT_GT(found, 250u);
}

}  // namespace
}  // namespace oplus::slide
