// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/convex_cover.hpp"

#include <gtest/gtest.h>

#include <array>

#include "checked/engines/engines.hpp"
#include "checked/slide/reduced_segments.hpp"
#include "checked/slide/slide.hpp"
#include "reference/definitions/point.hpp"
#include "reference/families/family.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

using Numbers = slide::SmallNumbers;

/// A staircase of short steps, on a box.
Region staircase(int steps) {
  Chain chain{{0, -steps}, {steps, -steps}};
  for (int i = steps; i-- > 0;) {
    chain.push_back({i + 1, steps - 1 - i});
    chain.push_back({i, steps - 1 - i});
  }
  chain.back() = {0, steps - 1};
  return polygon(std::move(chain));
}

const Region hexagon = polygon({{0, 0}, {12, -4}, {20, 4}, {20, 12}, {8, 16}, {0, 8}});

using ReducedSegment = slide::ReducedSegment<Numbers>;

Point place_on(const ReducedSegment& segment, const Rational& t) {
  const auto at = [&](std::int64_t source, std::int64_t direction) -> Rational {
    return Rational(source) + t * Rational(direction);
  };
  return {at(segment.exact.source.x, segment.exact.direction.x),
          at(segment.exact.source.y, segment.exact.direction.y)};
}

/// By the definition: whether the segment from one place to another is inside Q, moved to some vertex of P.
bool is_inside_at_a_vertex(const ReducedSegment& segment, const Rational& from, const Rational& to,
                           const Chain& p, const Chain& q) {
  const std::array<Point, 2> ends = {place_on(segment, from), place_on(segment, to)};
  return std::any_of(p.begin(), p.end(), [&](const Point& a) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Vector edge = q[(i + 1) % q.size()] - q[i];
      for (const Point& end : ends)
        if (cross(edge, end - (a - Point{0, 0}) - q[i]) <= 0) return false;
    }
    return true;
  });
}

TEST(ConvexCover, finds_only_segments_inside_a_convex_summand_at_a_vertex) {
  for (const bool convex_is_q : {true, false}) {
    const Region stairs = staircase(100);
    const Region& p = convex_is_q ? stairs : hexagon;
    const Region& q = convex_is_q ? hexagon : stairs;
    const slide::ReducedSegments<Numbers> segments(p, q, slide::scaling_of(p, q));
    slide::ConvexCover<Numbers> cover(segments.summands());
    std::size_t found = 0, inside = 0;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      const slide::ReducedSegment<Numbers> segment = segments[i];
      const bool is_inside = is_inside_at_a_vertex(segment, 0, 1, stairs.components[0].outer,
                                                   hexagon.components[0].outer);
      const bool is_found = cover.contains(segment);
      EXPECT_LE(is_found, is_inside) << i;
      found += is_found;
      inside += is_inside;
    }
    EXPECT_GT(inside, 50u);
    EXPECT_LT(inside, segments.size());
    EXPECT_GE(4 * found, 3 * inside);
  }
}

TEST(ConvexCover, finds_intervals_inside_a_convex_summand_at_a_vertex) {
  const Region stairs = staircase(60);
  const slide::ReducedSegments<Numbers> segments(stairs, hexagon,
                                                 slide::scaling_of(stairs, hexagon));
  slide::ConvexCover<Numbers> cover(segments.summands());
  const slide::Fraction<Numbers> half(1, 2);
  const Rational middle(1, 2);
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const auto interval = cover.interval_at(segments[i], half);
    if (!interval) continue;
    ++found;
    EXPECT_TRUE(interval->from < half && half < interval->to) << i;
    const Rational from = place_of(interval->from), to = place_of(interval->to);
    const Rational little(1, 1000000);
    EXPECT_TRUE(is_inside_at_a_vertex(segments[i], from + little * (middle - from),
                                      to + little * (middle - to), stairs.components[0].outer,
                                      hexagon.components[0].outer))
        << i;
  }
  EXPECT_GT(found, segments.size() / 2);
}

/// On a coast, most boxes that can have such a vertex have none: the search must be long enough to find it.
TEST(ConvexCover, finds_nearly_all_that_is_inside_a_coast_of_short_edges) {
  const Region coast = generate(*find_family("coast"), 50'000, 1).p;
  const Region disc = generate(*find_family("convex"), 20, 1).q;
  const Statistics found = slide_sum(coast, disc, Boundary::closed).statistics;
  EXPECT_LT(10 * found.count("probes"), found.count("segments slid along"));
}

TEST(ConvexCover, changes_no_sum) {
  const Engine& rca = *find_engine(engines(), "rca");
  std::size_t features = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const auto& [p, q] : {std::pair("pockets", "pockets"), std::pair("tight", "convex"),
                               std::pair("grid", "convex"), std::pair("convex", "comb")}) {
      const Region of_p = generate(*find_family(p), 60, seed).p;
      const Region of_q = generate(*find_family(q), 60, seed).q;
      for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
        const PlanarSet found = slide_sum(of_p, of_q, boundary).sum;
        EXPECT_TRUE(found == rca.compute(of_p, of_q, boundary, {}).sum) << p << ' ' << q << seed;
        features += found.dangling_edges.size() + found.isolated_vertices.size();
      }
    }
  }
  EXPECT_GT(features, 0u);
}

TEST(ConvexCover, is_of_one_summand_that_is_convex_and_has_few_edges) {
  const auto is_used = [](const Region& p, const Region& q) {
    return slide_sum(p, q, Boundary::closed)
               .statistics.count("segments inside a convex summand, moved") > 0;
  };
  EXPECT_TRUE(is_used(staircase(100), hexagon));
  EXPECT_FALSE(is_used(staircase(100), staircase(20)));
  Region with_hole = hexagon;
  with_hole.components[0].holes.push_back(backwards(box(8, 4, 10, 6)));
  EXPECT_FALSE(is_used(staircase(100), with_hole));
}

}  // namespace
}  // namespace oplus
