// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/plane_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/reference/chains/random_segments.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

struct Place {
  Point point;
  std::vector<std::uint32_t> points, left, right;
  std::optional<std::uint32_t> below, above;

  friend bool operator==(const Place&, const Place&) = default;
};

std::vector<Place> places(const SweptEdges& edges) {
  std::vector<Place> result;
  sweep(edges, [&](const SweptPlace& place) {
    result.push_back({place.point,
                      {place.points.begin(), place.points.end()},
                      {place.left.begin(), place.left.end()},
                      {place.right.begin(), place.right.end()},
                      place.below,
                      place.above});
    return true;
  });
  return result;
}

/// From its smaller end.
Segment rightward(const SweptEdges& edges, std::uint32_t e) {
  const Segment s{*edges.points[edges.edges[e].source], *edges.points[edges.edges[e].target]};
  return s.source < s.target ? s : reversed(s);
}

/// The same, from all pairs of edges.
std::vector<Place> places_by_definition(const SweptEdges& edges) {
  std::set<Point> all;
  for (const Point* p : edges.points) all.insert(*p);
  const auto count = static_cast<std::uint32_t>(edges.edges.size());
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = 0; b < a; ++b)
      for (const Point& p : intersection(rightward(edges, a), rightward(edges, b))) all.insert(p);
  std::vector<Place> result;
  for (const Point& p : all) {
    Place place{p, {}, {}, {}, {}, {}};
    for (std::uint32_t i = 0; i < edges.points.size(); ++i)
      if (*edges.points[i] == p) place.points.push_back(i);
    // Where an edge is directly to the left or right of p: the height first, then the slope.
    const auto is_lower = [&](std::uint32_t a, std::uint32_t b, bool to_the_right) {
      const int turn =
          sgn(cross(direction_of(rightward(edges, a)), direction_of(rightward(edges, b))));
      return turn != 0 ? (turn > 0) == to_the_right : a < b;
    };
    for (std::uint32_t e = 0; e < count; ++e) {
      const Segment s = rightward(edges, e);
      if (s.source == s.target || p < s.source || s.target < p) continue;
      if (lies_on(p, s)) {
        if (s.source < p) place.left.push_back(e);
        if (p < s.target) place.right.push_back(e);
        continue;
      }
      // The sweep line leans to the left above p, and to the right below it.
      const bool is_above = orientation(s.source, s.target, p) < 0;
      std::optional<std::uint32_t>& nearest = is_above ? place.above : place.below;
      const auto height = [&](std::uint32_t at) {
        const Segment line = rightward(edges, at);
        const Vector d = direction_of(line);
        return Rational(line.source.y + (p.x - line.source.x) * d.y / d.x);
      };
      const auto is_nearer = [&](std::uint32_t a, std::uint32_t b) {
        const int by_height = cmp(height(a), height(b));
        if (by_height != 0) return (by_height < 0) == is_above;
        return is_above ? is_lower(a, b, false) : is_lower(b, a, true);
      };
      if (!nearest || is_nearer(e, *nearest)) nearest = e;
    }
    std::sort(place.left.begin(), place.left.end(),
              [&](std::uint32_t a, std::uint32_t b) { return is_lower(a, b, false); });
    std::sort(place.right.begin(), place.right.end(),
              [&](std::uint32_t a, std::uint32_t b) { return is_lower(a, b, true); });
    result.push_back(std::move(place));
  }
  return result;
}

TEST(PlaneSweep, visits_what_all_pairs_of_edges_show) {
  Random random(20);
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Segment> segments = random_segments(random);
    SweptEdges edges;
    for (const Segment& s : segments) edges.add(s);
    const std::vector<Place> visited = places(edges), expected = places_by_definition(edges);
    ASSERT_EQ(visited.size(), expected.size()) << testing::PrintToString(segments);
    for (std::size_t j = 0; j < visited.size(); ++j)
      ASSERT_TRUE(visited[j] == expected[j]) << testing::PrintToString(segments) << " at "
                                             << testing::PrintToString(expected[j].point);
  }
}

TEST(PlaneSweep, ends_where_it_is_told_to) {
  const std::vector<Point> points{{1, 0}, {0, 0}, {2, 0}};
  SweptEdges edges;
  for (const Point& p : points) edges.add(p);
  std::vector<Point> visited;
  sweep(edges, [&](const SweptPlace& place) {
    visited.push_back(place.point);
    return visited.size() < 2;
  });
  EXPECT_EQ(visited, (std::vector<Point>{{0, 0}, {1, 0}}));
}

TEST(PlaneSweep, the_edge_of_a_chain_has_the_index_of_the_vertex_it_leaves) {
  const Chain square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, triangle{{3, 0}, {4, 0}, {3, 1}};
  SweptEdges edges;
  edges.add(square);
  edges.add(triangle);
  ASSERT_EQ(edges.edges.size(), 7u);
  EXPECT_EQ(edges.edges[3].target, 0u);
  EXPECT_EQ(edges.edges[6].source, 6u);
  EXPECT_EQ(edges.edges[6].target, 4u);
  EXPECT_TRUE(edges.runs_right(1)) << "upwards";
  EXPECT_FALSE(edges.runs_right(3)) << "downwards";
}

}  // namespace
}  // namespace oplus
