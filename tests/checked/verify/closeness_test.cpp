// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/closeness.hpp"

#include <gtest/gtest.h>

#include "checked/verify/root_number.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/families/family.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

Rational exact(const BoundaryDistance& d) {
  EXPECT_EQ(d.least_squared, d.most_squared);
  return d.least_squared;
}

TEST(RootNumber, compares_exactly) {
  const RootNumber root2{0, 1, 2};
  EXPECT_LT((RootNumber{Rational(141421356, 100000000)}), root2);
  EXPECT_GT((RootNumber{Rational(141421357, 100000000)}), root2);
  EXPECT_EQ((RootNumber{0, 2, 2}) <=> (RootNumber{0, 1, 8}), std::strong_ordering::equal);
  EXPECT_EQ((RootNumber{1, 0, 5}) <=> (RootNumber{3, -1, 4}), std::strong_ordering::equal);
  // 1 + √2 and √3 + 7/10: 2.41421 and 2.43205.
  EXPECT_LT((RootNumber{1, 1, 2}), (RootNumber{Rational(7, 10), 1, 3}));
  EXPECT_GT((RootNumber{-1, -1, 2}), (RootNumber{Rational(-7, 10), -1, 3}));
  EXPECT_EQ(sign(RootNumber{3, -1, 9}), 0);
  EXPECT_EQ(sign(RootNumber{0, -1, 9}), -1);
  EXPECT_EQ(sign(RootNumber{3, -1, 10}), -1);
}

TEST(Distance, of_a_set_from_itself_is_zero) {
  const std::vector<Segment> square = edges(Chain(box(0, 0, 2, 2)));
  EXPECT_EQ(exact(distance(square, square)), 0);
  std::vector<Segment> in_parts = cut(square[0], {{Rational(1, 3), 0}, {1, 0}});
  in_parts.insert(in_parts.end(), square.begin() + 1, square.end());
  EXPECT_EQ(exact(distance(square, in_parts)), 0);
  EXPECT_EQ(exact(distance(in_parts, square)), 0);
}

TEST(Distance, may_be_largest_inside_an_edge) {
  // Equally far from both ends, and nearer to them elsewhere.
  const std::vector<Segment> edge = {{{0, 0}, {2, 0}}};
  const std::vector<Segment> ends = {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}};
  const BoundaryDistance d = distance(edge, ends);
  EXPECT_EQ(exact(d), 1);
  EXPECT_EQ(d.farthest, (Point{1, 0}));
  EXPECT_FALSE(d.farthest_is_given);
  EXPECT_TRUE(distance(ends, edge).farthest_is_given);
}

TEST(Distance, that_is_a_root_is_between_bounds) {
  // Of the edge's point (t, 0) the squared distance is t² + 1 from the point, (t - 2)² / 2 from the
  // line: equal at t = √6 - 2, where they are 11 - 4 √6.
  const std::vector<Segment> others = {{{0, 1}, {0, 1}}, {{1, -1}, {4, 2}}};
  std::vector<Segment> all = others;
  all.push_back({{0, 0}, {2, 0}});
  const BoundaryDistance d = distance(all, others);
  const RootNumber right{11, -4, 6};
  EXPECT_LT(d.least_squared, d.most_squared);
  EXPECT_LT(RootNumber{d.least_squared}, right);
  EXPECT_GT(RootNumber{d.most_squared}, right);
  EXPECT_LE(d.most_squared, d.least_squared * (1 + Rational(1, 1 << 20)));
  EXPECT_TRUE(is_within(all, others, d.most_squared));
  EXPECT_FALSE(is_within(all, others, d.least_squared));
}

/// Two ways to the same: branch and bound, and intervals that cover.
TEST(Distance, is_what_is_within_says) {
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const auto [p, q] = generate(family, family.smallest + 2, seed);
      const std::vector<Segment> a = edges(p);
      const std::vector<Segment> b = edges(q);
      const BoundaryDistance d = distance(a, b);
      const auto within = [&](const Rational& squared) {
        return is_within(a, b, squared) && is_within(b, a, squared);
      };
      EXPECT_LE(d.most_squared, d.least_squared * (1 + Rational(1, 1 << 20)));
      EXPECT_TRUE(within(d.most_squared)) << family.name << seed;
      if (d.least_squared > 0) {
        EXPECT_FALSE(within(d.least_squared * Rational(99999, 100000))) << family.name << seed;
      }
    }
  }
}

const Region unit = polygon(box(0, 0, 1, 1));
const Region frame{{{box(0, 0, 5, 5), {backwards(box(2, 2, 3, 3))}}}};

TEST(Closeness, is_decided_exactly_at_the_tolerance) {
  const Region moved = translated(frame, {Rational(1, 10), 0});
  EXPECT_TRUE(closeness(canonical_sum(frame), {moved, {}, {}}, Rational(1, 10)).is_close());
  EXPECT_FALSE(
      closeness(canonical_sum(frame), {moved, {}, {}}, Rational(99999999, 1000000000)).is_close());
}

TEST(Closeness, each_chain_has_one_partner) {
  // Both given holes are near the one of the sum.
  const Region two{
      {{box(0, 0, 5, 5),
        {backwards(box(2, 2, 3, Rational(5, 2))), backwards(box(2, Rational(13, 5), 3, 3))}}}};
  const Closeness close = closeness(canonical_sum(frame), {two, {}, {}}, 1);
  EXPECT_TRUE(close.is_within);
  EXPECT_EQ(close.no_partners.size(), 1U);
}

TEST(Closeness, chains_that_cross_by_rounding_are_accepted_and_said) {
  // The hole sticks out of the outer chain by a hundredth.
  const Region right{{{box(0, 0, 5, 5), {backwards(box(2, Rational(1, 100), 3, 3))}}}};
  const Region given{{{box(0, 0, 5, 5), {backwards(box(2, Rational(-1, 100), 3, 3))}}}};
  const Closeness close = closeness(canonical_sum(right), {given, {}, {}}, Rational(2, 100));
  EXPECT_TRUE(close.is_within);
  EXPECT_FALSE(close.notes.empty());
  // The hole is open now.
  EXPECT_FALSE(close.no_partners.empty());
  const Region square = polygon(box(0, 0, 5, 5)),
               spike = polygon({{0, 0}, {7, 0}, {5, 0}, {5, 5}, {0, 5}});
  EXPECT_EQ(closeness(canonical_sum(square), {spike, {}, {}}, 2).notes,
            std::vector<std::string>{"chains cross, overlap or bound nothing in 1 place"});
}

TEST(Closeness, an_isolated_vertex_inside_the_given_sum_is_as_near_as_its_boundary) {
  const Rational half(1, 2);
  PlanarSet right = canonical_sum(unit);
  right.isolated_vertices = {{half, half}};
  EXPECT_TRUE(closeness(right, {unit, {}, {}}, half).is_close());
  EXPECT_FALSE(closeness(right, {unit, {}, {}}, half - Rational(1, 100)).is_close());
}

TEST(Closeness, of_nothing) {
  EXPECT_TRUE(closeness({}, {}, 0).is_close());
  const Closeness close = closeness(canonical_sum(unit), {}, 100);
  EXPECT_FALSE(close.has_same_chains());
  EXPECT_FALSE(close.distance.has_value());
  // A square of the diagonal 200 is not in it.
  EXPECT_TRUE(close.is_close());
  EXPECT_FALSE(closeness(canonical_sum(unit), {}, Rational(70, 100)).is_close());
  EXPECT_FALSE(closeness({}, {unit, {}, {}}, 100).is_close());
}

}  // namespace
}  // namespace oplus
