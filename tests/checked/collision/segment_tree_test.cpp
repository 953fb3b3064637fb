// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/segment_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/families/family.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// Short and long ones, equal ones, points; by a seed's own arithmetic.
std::vector<Segment> mixed_segments(std::size_t count, unsigned seed) {
  std::vector<Segment> result;
  const auto number = [&](int most) -> Rational {
    seed = seed * 1664525U + 1013904223U;
    const int whole = static_cast<int>((seed >> 8) % static_cast<unsigned>(2 * most + 1)) - most;
    return Rational(whole) / ((seed >> 28) % 3 + 1);
  };
  while (result.size() < count) {
    const Point p{number(20), number(20)};
    const int length = result.size() % 5 == 0 ? 30 : 3;
    const Vector along{number(length), number(length)};
    result.push_back({p, result.size() % 7 == 0 ? p : p + along});
    if (result.size() % 11 == 0) result.push_back(result.front());
  }
  return result;
}

Rational least_squared_distance(const Point& x, const std::vector<Segment>& segments) {
  Rational least = squared_distance(x, segments[0]);
  for (const Segment& s : segments) least = std::min(least, squared_distance(x, s));
  return least;
}

TEST(SegmentTree, finds_what_a_look_at_all_segments_finds) {
  for (const std::size_t count : {1U, 2U, 5U, 17U, 100U, 300U}) {
    const std::vector<Segment> segments = mixed_segments(count, static_cast<unsigned>(count));
    const SegmentTree tree(segments);
    for (const Segment& s : mixed_segments(60, 1)) {
      EXPECT_EQ(cut_where_met(s, tree), cut_where_met(s, segments));
      for (const Point& x : {s.source, midpoint(s.source, s.target), segments[count / 2].target}) {
        EXPECT_EQ(lies_on_one(x, tree), lies_on_one(x, segments));
        const Rational least = least_squared_distance(x, segments);
        EXPECT_EQ(squared_distance(x, tree, -1), least);
        EXPECT_EQ(squared_distance(x, tree, least / 2), least);
        EXPECT_LE(squared_distance(x, tree, least * 2), least * 2);
      }
    }
  }
}

TEST(SegmentTree, leaves_one_segment_out_of_a_distance) {
  const SegmentTree two(std::vector<Segment>{{{0, 0}, {4, 0}}, {{0, 3}, {4, 3}}});
  EXPECT_EQ(squared_distance({1, 1}, two, -1), 1);
  EXPECT_EQ(squared_distance({1, 1}, two, -1, 0), 4);
}

TEST(SegmentTree, of_huge_and_tiny_coordinates) {
  Rational huge = 1;
  for (int i = 0; i < 400; ++i) huge *= 10;
  const std::vector<Segment> segments = {
      {{0, 0}, {huge, 0}}, {{-huge, 1 / huge}, {huge, 1 / huge}}, {{0, huge}, {0, huge}}};
  const SegmentTree tree(segments);
  for (const Point& x : {Point{0, 0}, {huge, huge}, {1 / huge, 2 / huge}, {-huge, 0}}) {
    EXPECT_EQ(squared_distance(x, tree, -1), least_squared_distance(x, segments));
    EXPECT_EQ(lies_on_one(x, tree), lies_on_one(x, segments));
  }
}

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
  const bool stopped =
      SegmentTree(a).visit_meeting(SegmentTree(b), by, [&](std::size_t i, std::size_t j) {
        pairs.emplace_back(i, j);
        return false;
      });
  EXPECT_FALSE(stopped);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(PairsOfSegments, are_those_whose_boxes_meet_once_each) {
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

TEST(PairsOfSegments, are_visited_where_boxes_only_touch_and_where_segments_are_equal) {
  const Segment s{{0, 0}, {1, 1}};
  const std::vector<Segment> equal(9, s);
  EXPECT_EQ(visited(equal, equal, {0, 0}).size(), 81u);
  EXPECT_EQ(visited(equal, equal, {1, 1}).size(), 81u) << "corner to corner";
  EXPECT_TRUE(visited(equal, equal, {Rational(3, 2), 0}).empty());
}

TEST(PairsOfSegments, are_visited_where_boxes_touch_at_a_third) {
  const std::vector<Segment> a{{{0, 0}, {Rational(1, 3), 1}}};
  const std::vector<Segment> b{{{0, 0}, {1, 1}}};
  EXPECT_EQ(visited(a, b, {Rational(1, 3), 0}).size(), 1u);
}

TEST(PairsOfSegments, are_visited_until_a_call_returns_true) {
  const std::vector<Segment> a = scattered(40, 3);
  const SegmentTree tree(a);
  const std::size_t all = pairs_whose_boxes_meet(a, a, {0, 0}).size();
  for (std::size_t last = 1; last <= all; ++last) {
    std::size_t calls = 0;
    EXPECT_TRUE(tree.visit_meeting(tree, {0, 0},
                                   [&](std::size_t, std::size_t) { return ++calls == last; }));
    EXPECT_EQ(calls, last);
  }
}

TEST(PairsOfSegments, of_nothing_are_none) {
  EXPECT_TRUE(SegmentTree({}).empty());
  EXPECT_FALSE(SegmentTree(scattered(1, 3)).empty());
  EXPECT_TRUE(visited({}, scattered(5, 3), {0, 0}).empty());
  EXPECT_TRUE(visited(scattered(5, 3), {}, {0, 0}).empty());
}

TEST(PairsOfSegments, may_have_coordinates_that_no_double_holds) {
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
