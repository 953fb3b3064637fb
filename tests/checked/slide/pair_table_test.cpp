// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/pair_table.hpp"

#include <gtest/gtest.h>

#include <set>

#include "checked/slide/blocked_interval.hpp"
#include "checked/slide/contact_interval.hpp"
#include "reference/families/random.hpp"

namespace oplus::slide {
namespace {

using Edges = std::vector<IntegerSegment<SmallNumbers>>;
using Found = std::set<std::pair<std::uint32_t, std::uint32_t>>;

std::vector<NearSegment> near(const Edges& edges) {
  std::vector<NearSegment> result;
  for (const auto& e : edges)
    result.push_back(
        {double(e.source.x), double(e.source.y), double(e.direction.x), double(e.direction.y)});
  return result;
}

Found pairs_near(const Edges& p, const Edges& q, const IntegerSegment<SmallNumbers>& segment,
                 const PairTable::Margins& margins) {
  Found found;
  PairTable(near(p), near(q), p.size() * q.size())
      .each_near(near(Edges{segment})[0], margins, [&](const auto& pair) {
        EXPECT_TRUE(found.insert(pair).second) << "visited twice";
      });
  return found;
}

/// Some segments start at a vertex sum and run along an edge, as those of a convolution do.
void expect_none_left_out(std::size_t n, std::size_t m, int reach, std::uint64_t seed) {
  Random random(seed);
  const auto vector = [&]() -> IntegerVector<SmallNumbers> {
    return {uniform(random, -reach, reach), uniform(random, -reach, reach)};
  };
  const auto edges = [&](std::size_t count) {
    Edges result;
    while (result.size() < count) result.push_back({vector(), vector()});
    return result;
  };
  std::size_t blocked = 0, touched = 0, left_out = 0;
  for (int k = 0; k < 20; ++k) {
    const Edges p = edges(n), q = edges(m);
    for (int s = 0; s < 20; ++s) {
      IntegerSegment<SmallNumbers> segment{vector(), vector()};
      if (s % 2 == 0) {
        const auto& e = p[static_cast<std::size_t>(s) % n];
        segment = {e.source + q[static_cast<std::size_t>(s) % m].source, e.direction};
      }
      const Found crossing = pairs_near(p, q, segment, {0, 0.5});
      const Found touching = pairs_near(p, q, segment, {0.5, 0.5});
      left_out += n * m - touching.size();
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < m; ++j) {
          const auto interval = blocked_interval(segment, p[i], q[j], Shift::to_the_right);
          const Fraction<SmallNumbers> source{0, 1}, target{1, 1};
          if (interval && interval->from < target && source < interval->to) {
            ++blocked;
            EXPECT_TRUE(crossing.contains({i, j})) << i << ", " << j;
          }
          if (contact_interval(segment, p[i], q[j])) {
            ++touched;
            EXPECT_TRUE(touching.contains({i, j})) << i << ", " << j;
          }
        }
      }
    }
  }
  EXPECT_GT(blocked, 20u);
  EXPECT_GT(touched, blocked);
  EXPECT_GT(left_out, 20u);
}

TEST(PairTable, leaves_nothing_out_that_a_segment_meets) {
  expect_none_left_out(4, 4, 4, 1);
  expect_none_left_out(5, 3, 8, 2);
}

TEST(PairTable, leaves_nothing_out_where_many_pairs_are_remembered_at_a_time) {
  expect_none_left_out(17, 13, 8, 3);
  expect_none_left_out(256, 2, 8, 6);
  expect_none_left_out(3, 90, 8, 4);
}

TEST(PairTable, is_exact_up_to_24_bits) { expect_none_left_out(7, 6, (1 << 24) - 1, 5); }

TEST(PairTable, leaves_out_what_a_segment_only_touches) {
  const Edges p = {{{0, 0}, {4, 0}}}, q = {{{0, 0}, {0, 4}}};
  const IntegerSegment<SmallNumbers> from_side{{4, 2}, {3, 1}}, along_side{{0, 0}, {4, 0}};
  EXPECT_TRUE(pairs_near(p, q, from_side, {0, 0.5}).empty());
  EXPECT_EQ(pairs_near(p, q, from_side, {0.5, 0.5}).size(), 1u);
  EXPECT_EQ(pairs_near(p, q, along_side, {0, 0.5}).size(), 1u);
}

TEST(PairTable, is_empty_where_there_are_too_many_pairs) {
  const Edges three(3, {{0, 0}, {1, 1}}), many(200, {{0, 0}, {1, 1}});
  EXPECT_FALSE(PairTable(near(three), near(three), 9).is_empty());
  EXPECT_TRUE(PairTable(near(three), near(three), 8).is_empty());
  EXPECT_TRUE(PairTable(near(three), near(many), 1000).is_empty());
  const Edges most(256, {{0, 0}, {1, 1}}), too_many(257, {{0, 0}, {1, 1}});
  EXPECT_FALSE(PairTable(near(most), near(three), 1000).is_empty());
  EXPECT_TRUE(PairTable(near(too_many), near(three), 1000).is_empty());
}

}  // namespace
}  // namespace oplus::slide
