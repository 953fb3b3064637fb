// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/convolution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "reference/definitions/tangent_set.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// Over all chains: a turn, +1 or -1, and another for each reflex vertex.
int directions_covered(const Region& region) {
  int covered = 0;
  for (const Chain& chain : chains(region)) {
    covered += sign(twice_area(chain));
    for (std::size_t i = 0; i < chain.size(); ++i)
      covered +=
          orientation(chain[previous(i, chain.size())], chain[i], chain[next(i, chain.size())]) < 0;
  }
  return covered;
}

std::vector<Segment> sorted(std::vector<Segment> segments) {
  std::sort(segments.begin(), segments.end());
  return segments;
}

TEST(Convolution, vertex_edge_sum_has_every_pair_once) {
  for (const Shape& p : shapes()) {
    for (const Shape& q : shapes()) {
      const auto sums = vertex_edge_sum(p.region, q.region);
      const std::size_t pairs = vertex_count(p.region) * vertex_count(q.region);
      ASSERT_EQ(sums.size(), 2 * pairs);
      std::vector<Origin> origins;
      for (const ConvolutionSegment& s : sums) origins.push_back(s.origin);
      std::sort(origins.begin(), origins.end());
      ASSERT_EQ(std::unique(origins.begin(), origins.end()), origins.end());
    }
  }
}

TEST(Convolution, each_segment_is_the_sum_of_the_vertex_and_the_edge_it_names) {
  for (const Shape& p : shapes()) {
    for (const Shape& q : shapes()) {
      for (const ConvolutionSegment& s : vertex_edge_sum(p.region, q.region)) {
        const bool of_p = s.origin.edge_of == Summand::P;
        const Chain with_edge = chains(of_p ? p.region : q.region)[s.origin.edge.chain];
        const Chain with_vertex = chains(of_p ? q.region : p.region)[s.origin.vertex.chain];
        const std::size_t i = s.origin.edge.vertex;
        const std::size_t j = s.origin.vertex.vertex;
        const Point& v = with_vertex[j];
        ASSERT_EQ(s.segment, (Segment{with_edge[i] + v, with_edge[next(i, with_edge.size())] + v}));
        ASSERT_EQ(s.vertex_is_reflex, is_reflex({v - with_vertex[previous(j, with_vertex.size())],
                                                 with_vertex[next(j, with_vertex.size())] - v}));
      }
    }
  }
}

TEST(Convolution, has_as_many_segments_as_its_reflex_vertices_say) {
  for (const Shape& p : shapes()) {
    for (const Shape& q : shapes()) {
      const int n = static_cast<int>(vertex_count(p.region));
      const int m = static_cast<int>(vertex_count(q.region));
      ASSERT_EQ(static_cast<int>(convolution(p.region, q.region).size()),
                n * directions_covered(q.region) + m * directions_covered(p.region))
          << p.name << " + " << q.name;
    }
  }
}

TEST(Convolution, enters_each_point_as_often_as_it_leaves_it) {
  for (const Shape& p : shapes()) {
    for (const Shape& q : shapes()) {
      std::map<Point, int> surplus;
      for (const Segment& s : segments(convolution(p.region, q.region))) {
        ++surplus[s.source];
        --surplus[s.target];
      }
      for (const auto& [point, leaving_minus_entering] : surplus)
        ASSERT_EQ(leaving_minus_entering, 0)
            << p.name << " + " << q.name << " at " << testing::PrintToString(point);
    }
  }
}

TEST(Convolution, of_two_unit_squares_runs_once_around_their_sum) {
  const Region square = polygon(box(0, 0, 1, 1));
  const std::vector<Segment> expected{{{0, 0}, {1, 0}}, {{0, 1}, {0, 0}}, {{0, 2}, {0, 1}},
                                      {{1, 0}, {2, 0}}, {{1, 2}, {0, 2}}, {{2, 0}, {2, 1}},
                                      {{2, 1}, {2, 2}}, {{2, 2}, {1, 2}}};
  EXPECT_EQ(sorted(segments(convolution(square, square))), expected);
}

TEST(Convolution, of_a_square_and_a_diamond_is_the_octagon) {
  const Region square = polygon(box(0, 0, 2, 2));
  const Region diamond = polygon({{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  const std::vector<Segment> expected{{{-1, 0}, {0, -1}}, {{-1, 2}, {-1, 0}}, {{0, -1}, {2, -1}},
                                      {{0, 3}, {-1, 2}},  {{2, -1}, {3, 0}},  {{2, 3}, {0, 3}},
                                      {{3, 0}, {3, 2}},   {{3, 2}, {2, 3}}};
  EXPECT_EQ(sorted(segments(convolution(square, diamond))), expected);
}

TEST(Convolution, reduced_leaves_out_the_reflex_vertices_and_nothing_else) {
  const Region l = polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const Region square = polygon(box(0, 0, 1, 1));
  EXPECT_EQ(convolution(l, square).size(), 6u * 1 + 4u * 2);
  const auto reduced = reduced_convolution(l, square);
  EXPECT_EQ(reduced.size(), 14u - 4 + 1) << "vertex (1,1) meets all but one edge of the square";
  for (const ConvolutionSegment& s : reduced)
    EXPECT_FALSE(s.origin.edge_of == Summand::Q && s.origin.vertex.vertex == 3);
}

TEST(Convolution, with_the_empty_region_is_empty) {
  EXPECT_TRUE(convolution(Region{}, polygon(box(0, 0, 1, 1))).empty());
  EXPECT_TRUE(vertex_edge_sum(Region{}, Region{}).empty());
}

}  // namespace
}  // namespace oplus
