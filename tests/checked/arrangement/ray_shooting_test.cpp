// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/ray_shooting.hpp"

#include <gtest/gtest.h>

#include "checked/arrangement/winding_numbers.hpp"
#include "properties/compare/corpus.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

std::vector<Segment> along(std::initializer_list<Chain> chains) {
  std::vector<Segment> segments;
  for (const Chain& chain : chains)
    for (const Segment& e : edges(chain)) segments.push_back(e);
  return segments;
}

TEST(RayShooting, right_and_left_of_each_side_of_a_square) {
  const std::vector<Segment> square = along({box(0, 0, 2, 2)});
  const RayShooting rays(square);
  for (const Segment& side : square) {
    EXPECT_EQ(rays.winding_number_right_of(side), 0);
    EXPECT_EQ(rays.winding_number_right_of(reversed(side)), 1);
  }
}

TEST(RayShooting, of_segments_that_are_not_in_it) {
  const RayShooting rays(along({box(0, 0, 4, 4), box(1, 1, 3, 3)}));
  // Horizontal ones at the height of vertices: the face below or above it decides.
  EXPECT_EQ(rays.winding_number_right_of({{1, 1}, {3, 1}}), 1);
  EXPECT_EQ(rays.winding_number_right_of({{3, 1}, {1, 1}}), 2);
  EXPECT_EQ(rays.winding_number_right_of({{1, 3}, {3, 3}}), 2);
  EXPECT_EQ(rays.winding_number_right_of({{3, 3}, {1, 3}}), 1);
  // Across an edge: the shift upwards comes first, then that to the right.
  EXPECT_EQ(rays.winding_number_right_of({{2, 0}, {2, 2}}), 2);
  EXPECT_EQ(rays.winding_number_right_of({{2, 2}, {2, 0}}), 2);
  // Through a vertex, along a diagonal.
  EXPECT_EQ(rays.winding_number_right_of({{0, 0}, {2, 2}}), 2);
  EXPECT_EQ(rays.winding_number_right_of({{0, 2}, {2, 0}}), 1);
  EXPECT_EQ(rays.winding_number_right_of({{9, 1}, {9, 3}}), 0);
  EXPECT_EQ(rays.winding_number_right_of({{-9, 1}, {-9, 3}}), 0);
  EXPECT_EQ(rays.winding_number_right_of({{2, 9}, {3, 9}}), 0);
}

TEST(RayShooting, through_overlapping_segments_counts_each) {
  const std::vector<Segment> twice = along({box(0, 0, 2, 2), box(0, 0, 2, 2)});
  const RayShooting rays(twice);
  for (const Segment& side : twice) {
    EXPECT_EQ(rays.winding_number_right_of(side), 0);
    EXPECT_EQ(rays.winding_number_right_of(reversed(side)), 2);
  }
  const RayShooting none(along({box(0, 0, 2, 2), backwards(box(0, 0, 2, 2))}));
  for (const Segment& side : twice) EXPECT_EQ(none.winding_number_right_of(reversed(side)), 0);
}

TEST(RayShooting, of_nothing_is_zero) {
  EXPECT_EQ(RayShooting({}).winding_number_right_of({{0, 0}, {1, 0}}), 0);
}

TEST(RayShooting, beside_every_edge_of_every_row_is_the_winding_number_of_the_face) {
  std::size_t positive = 0;
  for (const CorpusPair& row : corpus()) {
    const std::vector<ConvolutionSegment> full = convolution(row.p, row.q);
    const RayShooting rays(segments(full));
    const ConvolutionArrangement a(full);
    const std::vector<int> of_faces = winding_numbers(a);
    for (ConvolutionArrangement::Halfedge h = 0; h < 2 * a.edge_count(); ++h) {
      const int expected = of_faces[a.face(ConvolutionArrangement::twin(h))];
      EXPECT_EQ(rays.winding_number_right_of(a.geometry(h)), expected) << row.name;
      positive += expected > 1;
    }
  }
  EXPECT_GT(positive, 20u);
}

}  // namespace
}  // namespace oplus
