// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/contact_interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers = SmallNumbers>
std::optional<Places> contact(const Segment& segment, const Segment& of_p, const Segment& of_q) {
  return places(contact_interval(integer_segment<Numbers>(segment), integer_segment<Numbers>(of_p),
                                 integer_segment<Numbers>(of_q)));
}

/// However the edges are directed, whichever is of P, and turned by quarters.
void expect_contact(Segment segment, Segment of_p, Segment of_q,
                    const std::optional<Places>& expected) {
  for (int turns = 0; turns < 4; ++turns) {
    for (const Segment& p : {of_p, reversed(of_p)}) {
      for (const Segment& q : {of_q, reversed(of_q)}) {
        EXPECT_EQ(contact(segment, p, q), expected) << turns;
        EXPECT_EQ(contact(segment, q, p), expected) << turns;
        EXPECT_EQ(contact(reversed(segment), p, q), from_the_end(expected)) << turns;
      }
    }
    for (Segment* each : {&segment, &of_p, &of_q}) *each = image(quarter_turns(1), *each);
  }
}

// The sum of these is the closed rectangle from (0, 0) to (4, 2).
const Segment across{{0, 0}, {4, 0}}, up{{0, 0}, {0, 2}};

TEST(ContactInterval, is_where_the_segment_is_in_the_closed_parallelogram) {
  expect_contact({{-1, 1}, {9, 1}}, across, up, Places{{1, 10}, {1, 2}});
  expect_contact({{1, 1}, {2, 1}}, across, up, Places{0, 1});
  expect_contact({{1, 1}, {9, 1}}, across, up, Places{0, {3, 8}});
  expect_contact({{-1, 3}, {9, 3}}, across, up, std::nullopt);
  expect_contact({{-9, 1}, {-1, 1}}, across, up, std::nullopt);
}

TEST(ContactInterval, has_sides_corners_and_ends) {
  expect_contact({{-1, 0}, {9, 0}}, across, up, Places{{1, 10}, {1, 2}});
  expect_contact({{-1, 2}, {9, 2}}, across, up, Places{{1, 10}, {1, 2}});
  expect_contact({{-1, 1}, {1, -1}}, across, up, Places{{1, 2}, {1, 2}});
  expect_contact({{3, 3}, {6, 0}}, across, up, Places{{1, 3}, {1, 3}});
  expect_contact({{4, 1}, {9, 1}}, across, up, Places{0, 0});
  expect_contact({{-5, 7}, {0, 2}}, across, up, Places{1, 1});
}

TEST(ContactInterval, of_parallel_edges_is_empty) {
  // In line, behind each other, side by side; slid along them and across.
  for (const Segment& parallel :
       {Segment{{0, 0}, {2, 0}}, Segment{{10, 0}, {12, 0}}, Segment{{0, 5}, {2, 5}}}) {
    for (const Segment& slid : {Segment{{-2, 0}, {8, 0}}, Segment{{8, 0}, {18, 0}},
                                Segment{{-2, 5}, {8, 5}}, Segment{{3, -1}, {3, 9}}})
      expect_contact(slid, across, parallel, std::nullopt);
  }
}

/// -Q + x against P, as it is defined.
TEST(ContactInterval, is_where_the_edges_meet) {
  Random random(5);
  std::size_t points = 0, pieces = 0;
  for (int k = 0; k < 1500; ++k) {
    const Segment p = random_segment(random, 2);
    const Segment q = random_segment(random, 2);
    const Point x = random_point(random, 2) + random_point(random, 2);
    const Segment slid{x, x + direction_of(one_in(random, 2) ? p : random_segment(random, 2))};
    if (cross(direction_of(p), direction_of(q)) == 0) continue;
    const std::optional<Places> places = contact(slid, p, q);
    const auto meet_at = [&](const Rational& t) {
      const Point at = slid.source + t * direction_of(slid);
      return !intersection(p, {at - q.source, at - q.target}).empty();
    };
    std::vector<Rational> asked;
    for (int i = 0; i <= 12; ++i) asked.emplace_back(i, 12);
    if (places) {
      (places->from == places->to ? points : pieces) += 1;
      asked.insert(asked.end(), {places->from, places->to, (places->from + places->to) / 2});
    }
    for (const Rational& t : asked)
      EXPECT_EQ(meet_at(t), places && places->from <= t && t <= places->to)
          << testing::PrintToString(p) << testing::PrintToString(q) << testing::PrintToString(slid)
          << " at " << t;
  }
  EXPECT_GT(points, 100u);
  EXPECT_GT(pieces, 100u);
}

template <typename Numbers>
class ContactIntervalAtTheLimit : public testing::Test {};
TYPED_TEST_SUITE(ContactIntervalAtTheLimit, LimitedNumbers);

TYPED_TEST(ContactIntervalAtTheLimit, is_that_of_gmp) {
  std::size_t found = 0;
  for_each_slid_edge_at_the_limit<TypeParam>(
      [&](const Segment& slid, const Segment& of_p, const Segment& of_q) {
        const auto expected = contact<AnyNumbers>(slid, of_p, of_q);
        EXPECT_EQ(contact<TypeParam>(slid, of_p, of_q), expected);
        found += expected ? 1 : 0;
      });
  EXPECT_GT(found, 125u);
}

}  // namespace
}  // namespace oplus::slide
