// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/segment_tree.hpp"

#include <gtest/gtest.h>

#include "checked/verify/witness.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/definitions/verdicts_differ.hpp"
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

TEST(PointNear, is_beside_its_edge_and_nearer_to_it_than_to_others) {
  // The square's left side is touched in its middle, by a triangle's vertex.
  std::vector<Segment> all = edges(Chain(box(0, 0, Rational(1, 1000000), 8)));
  const std::vector<Segment> triangle = edges(Chain{{-3, 3}, {0, 4}, {-3, 5}});
  all.insert(all.end(), triangle.begin(), triangle.end());
  const SegmentTree tree(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const bool left : {true, false}) {
      const Point x = point_near(tree, i, left);
      EXPECT_EQ(orientation(all[i].source, all[i].target, x), left ? 1 : -1);
      const Rational near = squared_distance(x, all[i]);
      EXPECT_GT(near, 0);
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (j != i) {
          EXPECT_GT(squared_distance(x, all[j]), 0);
        }
      }
    }
  }
}

TEST(PointNear, is_not_found_where_edges_overlap) {
  const SegmentTree tree({{{0, 0}, {1, 0}}, {{1, 0}, {0, 0}}});
  EXPECT_THROW(point_near(tree, 0, true), VerdictsDiffer);
}

}  // namespace
}  // namespace oplus
