// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/convex_cover.hpp"

#include <gtest/gtest.h>

#include "checked/slide/slide.hpp"
#include "checked/slide/tracks.hpp"
#include "reference/definitions/point.hpp"
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

/// By the definition: whether both ends are inside Q, moved to some vertex of P.
bool is_inside_at_a_vertex(const slide::IntegerSegment<Numbers>& segment, const Chain& p,
                           const Chain& q) {
  const Point from{Rational(segment.source.x), Rational(segment.source.y)};
  const Point to = from + Vector{Rational(segment.direction.x), Rational(segment.direction.y)};
  return std::any_of(p.begin(), p.end(), [&](const Point& a) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Vector edge = q[(i + 1) % q.size()] - q[i];
      for (const Point& end : {from, to})
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
    const slide::Tracks<Numbers> tracks(p, q, slide::scaling_of(p, q));
    slide::ConvexCover<Numbers> cover(tracks.summands());
    std::size_t found = 0, inside = 0;
    for (std::uint32_t i = 0; i < tracks.size(); ++i) {
      const slide::Track<Numbers> track = tracks[i];
      const bool is_inside = is_inside_at_a_vertex(track.exact, stairs.components[0].outer,
                                                   hexagon.components[0].outer);
      const bool is_found = cover.contains(track);
      EXPECT_LE(is_found, is_inside) << i;
      found += is_found;
      inside += is_inside;
    }
    EXPECT_GT(inside, 100u);
    EXPECT_LT(inside, tracks.size());
    EXPECT_GE(10 * found, 9 * inside);
  }
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
