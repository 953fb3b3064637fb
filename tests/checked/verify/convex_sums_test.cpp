// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/convex_sums.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "checked/verify/sum_by_convex_parts.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/families/family.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

struct Pair {
  std::string name;
  Region p;
  Region q;
};

/// Of all families, with at most that many pairs of vertices each.
std::vector<Pair> pairs_of_families(std::size_t largest) {
  std::vector<Pair> pairs;
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {4U, 5U, 6U, 7U, 8U, 9U}) {
      auto [p, q] = generate(family, family.smallest + 1, seed);
      if (vertex_count(p) * vertex_count(q) <= largest)
        pairs.push_back({family.name + " " + std::to_string(seed), std::move(p), std::move(q)});
    }
  }
  return pairs;
}

/// A map that keeps directions, convexity and the order of points.
struct Stretch {
  Rational x, y;
  Vector of_p, of_q;

  Point operator()(const Point& p, const Vector& by) const {
    return {x * p.x + by.x, y * p.y + by.y};
  }
  Region operator()(const Region& region, const Vector& by) const {
    return mapped(region, [&](const Point& p) { return (*this)(p, by); });
  }
  PlanarSet operator()(PlanarSet sum) const {
    const Vector by = of_p + of_q;
    for (std::vector<Chain>* of_sum : {&sum.outer, &sum.holes})
      for (Chain& chain : *of_sum)
        for (Point& p : chain) p = (*this)(p, by);
    for (Segment& s : sum.dangling_edges) s = {(*this)(s.source, by), (*this)(s.target, by)};
    for (Point& p : sum.isolated_vertices) p = (*this)(p, by);
    return sum;
  }
};

/// Integers below 2^23, beyond, fractions that are no doubles, and what is no double at all.
TEST(SumByConvexParts, does_not_depend_on_the_size_of_numbers) {
  Rational huge = 1;
  for (int i = 0; i < 400; ++i) huge *= 10;
  const Stretch stretches[] = {
      {Rational(1, 3), Rational(5, 7), {Rational(1, 11), 0}, {0, Rational(1, 13)}},
      {1, 1, {8388607, 0}, {8388607, -8388608}},
      {1, 1, {1048583 * Rational(1048573), 5}, {-5, 1048583}},
      {Rational(1, 1024), 1024, {0, 0}, {0, Rational(1, 1048576)}},
      {huge, 1, {0, huge}, {1, 1}},
      {1 / huge, huge, {1, 1}, {-huge, Rational(1, 3)}},
  };
  std::size_t features = 0;
  for (const auto& [name, p, q] : pairs_of_families(200)) {
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      const PlanarSet sum = sum_by_convex_parts(p, q, boundary);
      features += sum.dangling_edges.size() + sum.isolated_vertices.size();
      for (const Stretch& stretch : stretches)
        EXPECT_EQ(sum_by_convex_parts(stretch(p, stretch.of_p), stretch(q, stretch.of_q), boundary),
                  stretch(sum))
            << name << ", " << &stretch - stretches;
    }
  }
  EXPECT_GT(features, 10U);
}

std::vector<Segment> reduced_segments(const Region& p, const Region& q) {
  const ConvexSums sums(p, q);
  std::vector<Segment> all;
  for (const ConvexSums::EdgeAtVertex& candidate : sums.reduced_convolution())
    all.push_back(sums.segment(candidate));
  std::sort(all.begin(), all.end());
  return all;
}

TEST(ConvexSums, leave_out_copies_of_segments_of_small_integers_and_nothing_else) {
  std::vector<Pair> pairs = pairs_of_families(200);
  Region stairs;
  for (int i = 0; i < 6; ++i)
    stairs.components.push_back({{{2 * i, 2 * i}, {2 * i + 1, 2 * i}, {2 * i + 1, 2 * i + 1}}, {}});
  pairs.push_back({"stairs", stairs, stairs});
  const auto third = [](const Region& region) {
    return mapped(region, [](const Point& v) { return Rational(1, 3) * v; });
  };
  std::size_t copies = 0;
  for (const auto& [name, p, q] : pairs) {
    const std::vector<Segment> all = reduced_segments(p, q);
    std::vector<Segment> general;
    for (const Segment& s : reduced_segments(third(p), third(q)))
      general.push_back({Rational(3) * s.source, Rational(3) * s.target});
    copies += general.size() - all.size();
    EXPECT_EQ(all, sorted_without_copies(std::move(general))) << name;
  }
  EXPECT_GT(copies, 50U);
}

/// On no segment of the reduced convolution (docs/findings.md, Theorem 2.3.2).
TEST(SumByConvexParts, isolated_vertices_where_chains_of_both_summands_touch) {
  const Region room{{{{{0, 0}, {4, 0}, {8, 0}, {8, 4}, {8, 8}, {4, 8}, {0, 8}, {0, 4}},
                      {{{0, 4}, {4, 8}, {8, 4}, {4, 0}}}}}};
  EXPECT_EQ(sum_by_convex_parts(room, room, Boundary::open).isolated_vertices,
            (std::vector<Point>{{4, 4}, {4, 12}, {12, 4}, {12, 12}}));
}

}  // namespace
}  // namespace oplus
