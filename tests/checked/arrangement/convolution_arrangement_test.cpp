// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/convolution_arrangement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "properties/compare/corpus.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

using Halfedge = ConvolutionArrangement::Halfedge;

TEST(ConvolutionArrangement, of_two_squares) {
  const Region square = polygon(box(0, 0, 1, 1));
  const ConvolutionArrangement a(convolution(square, square));
  EXPECT_EQ(a.segment_count(), 8u);
  EXPECT_EQ(a.vertex_count(), 8u);
  EXPECT_EQ(a.edge_count(), 8u);
  ASSERT_EQ(a.face_count(), 2u);
  const auto has_its_segment_to_the_left = [&](Halfedge h) { return a.along(h).size() == 1; };
  const auto has_its_segment_to_the_right = [&](Halfedge h) { return a.along(h).empty(); };
  EXPECT_TRUE(a.all_around(1, has_its_segment_to_the_left));
  EXPECT_TRUE(a.all_around(ConvolutionArrangement::unbounded, has_its_segment_to_the_right));
}

TEST(ConvolutionArrangement, of_nothing_is_the_unbounded_face) {
  const ConvolutionArrangement a({});
  EXPECT_EQ(a.vertex_count(), 0u);
  EXPECT_EQ(a.edge_count(), 0u);
  ASSERT_EQ(a.face_count(), 1u);
  EXPECT_TRUE(a.boundaries(ConvolutionArrangement::unbounded).empty());
}

TEST(ConvolutionArrangement, is_a_doubly_connected_edge_list) {
  for (const CorpusPair& row : corpus()) {
    const ConvolutionArrangement a(convolution(row.p, row.q));
    std::size_t around_faces = 0;
    for (ConvolutionArrangement::Face f = 0; f < a.face_count(); ++f) {
      a.all_around(f, [&](Halfedge h) {
        ++around_faces;
        EXPECT_EQ(a.face(h), f) << row.name;
        EXPECT_EQ(a.source(a.next(h)), a.target(h)) << row.name;
        EXPECT_EQ(a.source(a.clockwise(h)), a.source(h)) << row.name;
        return true;
      });
    }
    EXPECT_EQ(around_faces, 2 * a.edge_count()) << row.name << ": each halfedge is on one boundary";
    for (Halfedge h = 0; h < 2 * a.edge_count(); h += 2)
      EXPECT_LT(a.point(a.source(h)), a.point(a.target(h))) << row.name;
    for (ConvolutionArrangement::Vertex v = 0; v < a.vertex_count(); ++v)
      EXPECT_EQ(a.source(a.leaving(v)), v) << row.name;
  }
}

TEST(ConvolutionArrangement, edges_know_exactly_the_segments_they_are_parts_of) {
  for (const CorpusPair& row : corpus()) {
    const std::vector<ConvolutionSegment> segments = reduced_convolution(row.p, row.q);
    const ConvolutionArrangement a(segments);
    for (Halfedge h = 0; h < 2 * a.edge_count(); ++h) {
      const Segment edge = a.geometry(h);
      std::multiset<Origin> expected;
      for (const ConvolutionSegment& s : segments) {
        if (lies_on(edge.source, s.segment) && lies_on(edge.target, s.segment) &&
            same_direction(direction_of(edge), direction_of(s.segment)))
          expected.insert(s.origin);
      }
      std::multiset<Origin> along;
      for (const std::uint32_t i : a.along(h)) along.insert(a.segment(i).origin);
      ASSERT_EQ(along.size(), expected.size()) << row.name;
      ASSERT_TRUE(along == expected) << row.name;
    }
  }
}

TEST(ConvolutionArrangement, turns_clockwise_around_a_vertex) {
  // Two bars across each other: four halfedges leave each crossing.
  const Region flat = polygon(box(0, 0, 4, 1));
  const Region frame{{{box(0, 0, 9, 9), {backwards(box(1, 1, 8, 8))}}}};
  const ConvolutionArrangement a(convolution(frame, flat));
  std::size_t crossings = 0;
  for (ConvolutionArrangement::Vertex v = 0; v < a.vertex_count(); ++v) {
    std::vector<Vector> directions;
    Halfedge h = a.leaving(v);
    do {
      directions.push_back(direction_of(a.geometry(h)));
      h = a.clockwise(h);
    } while (h != a.leaving(v));
    if (directions.size() < 3) continue;
    ++crossings;
    // Once around: exactly one step does not lower the angle.
    std::size_t rises = 0;
    for (std::size_t i = 0; i < directions.size(); ++i)
      rises += compare_angle(directions[i], directions[next(i, directions.size())]) < 0;
    EXPECT_EQ(rises, 1u);
  }
  EXPECT_GT(crossings, 0u);
}

}  // namespace
}  // namespace oplus
