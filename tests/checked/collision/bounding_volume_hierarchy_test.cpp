// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/bounding_volume_hierarchy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Segments all over a square, by multiplication modulo a prime: some points, some long.
std::vector<Segment> scattered(std::size_t count, int start) {
  std::vector<Segment> segments;
  int value = start;
  const auto next_value = [&] { return value = value * 31 % 101; };
  for (std::size_t i = 0; i < count; ++i) {
    const Point source{next_value(), next_value()};
    const int reach = i % 10 == 0 ? 60 : 7;
    segments.push_back({source, source + Vector{next_value() % reach, -(next_value() % reach)}});
  }
  return segments;
}

bool meet(const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
  return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b);
}

Pairs pairs_whose_boxes_meet(const std::vector<Segment>& a, const std::vector<Segment>& b,
                             const Vector& by) {
  Pairs pairs;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Point source = b[j].source + by;
      const Point target = b[j].target + by;
      if (meet(a[i].source.x, a[i].target.x, source.x, target.x) &&
          meet(a[i].source.y, a[i].target.y, source.y, target.y))
        pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

Pairs visited(const std::vector<Segment>& a, const std::vector<Segment>& b, const Vector& by) {
  Pairs pairs;
  const bool stopped = BoundingVolumeHierarchy(a).visit_meeting(BoundingVolumeHierarchy(b), by,
                                                                [&](std::size_t i, std::size_t j) {
                                                                  pairs.emplace_back(i, j);
                                                                  return false;
                                                                });
  EXPECT_FALSE(stopped);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(BoundingVolumeHierarchy, visits_exactly_the_pairs_whose_boxes_meet_once_each) {
  std::size_t met = 0;
  for (const std::size_t count : {1, 2, 3, 5, 40}) {
    const std::vector<Segment> a = scattered(count, 3);
    const std::vector<Segment> b = scattered(40, 5);
    for (const Vector& by : {Vector{0, 0}, {25, -40}, {Rational(-41, 2), 12}, {500, 0}}) {
      const Pairs expected = pairs_whose_boxes_meet(a, b, by);
      EXPECT_EQ(visited(a, b, by), expected);
      met += expected.size();
    }
  }
  EXPECT_GT(met, 100u) << "the segments miss each other: nothing was tested";
}

TEST(BoundingVolumeHierarchy, visits_boxes_that_only_touch_and_equal_segments) {
  const Segment s{{0, 0}, {1, 1}};
  const std::vector<Segment> equal(9, s);
  EXPECT_EQ(visited(equal, equal, {0, 0}).size(), 81u);
  EXPECT_EQ(visited(equal, equal, {1, 1}).size(), 81u) << "corner to corner";
  EXPECT_TRUE(visited(equal, equal, {Rational(3, 2), 0}).empty());
}

TEST(BoundingVolumeHierarchy, misses_no_pair_of_boxes_that_touch_at_a_third) {
  const std::vector<Segment> a{{{0, 0}, {Rational(1, 3), 1}}};
  const std::vector<Segment> b{{{0, 0}, {1, 1}}};
  EXPECT_EQ(visited(a, b, {Rational(1, 3), 0}).size(), 1u);
}

TEST(BoundingVolumeHierarchy, stops_at_the_first_true) {
  const std::vector<Segment> a = scattered(40, 3);
  const BoundingVolumeHierarchy hierarchy(a);
  const std::size_t all = pairs_whose_boxes_meet(a, a, {0, 0}).size();
  for (std::size_t last = 1; last <= all; ++last) {
    std::size_t calls = 0;
    EXPECT_TRUE(hierarchy.visit_meeting(hierarchy, {0, 0},
                                        [&](std::size_t, std::size_t) { return ++calls == last; }));
    EXPECT_EQ(calls, last);
  }
}

TEST(BoundingVolumeHierarchy, over_nothing_visits_nothing) {
  EXPECT_TRUE(BoundingVolumeHierarchy({}).empty());
  EXPECT_FALSE(BoundingVolumeHierarchy(scattered(1, 3)).empty());
  EXPECT_TRUE(visited({}, scattered(5, 3), {0, 0}).empty());
  EXPECT_TRUE(visited(scattered(5, 3), {}, {0, 0}).empty());
}

TEST(BoundingVolumeHierarchy, holds_coordinates_that_no_double_holds) {
  const Rational huge("1" + std::string(400, '0'));
  std::vector<Segment> segments;
  for (int i = -20; i < 20; ++i)
    segments.push_back({{i * huge, -i * huge}, {(i + 1) * huge, i * huge}});
  const Pairs pairs = visited(segments, segments, {0, 0});
  for (const auto& pair : pairs_whose_boxes_meet(segments, segments, {0, 0}))
    EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), pair));
}

}  // namespace
}  // namespace oplus
