// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/face_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "checked/arrangement/winding_numbers.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/definitions/pairs_of_shapes.hpp"

namespace oplus {
namespace {

using Face = ConvolutionArrangement::Face;

/// Each segment a chain of its own, so that all are tested for intersections.
ConvolutionArrangement arrangement_of(const std::vector<Segment>& segments) {
  std::vector<ConvolutionSegment> labelled;
  for (const Segment& s : segments)
    labelled.push_back({s, {Summand::P, {labelled.size(), 0}, {}}, false});
  return ConvolutionArrangement(labelled);
}

std::vector<Segment> edges_of(std::initializer_list<Chain> chains) {
  std::vector<Segment> result;
  for (const Chain& chain : chains) {
    const std::vector<Segment> of_chain = edges(chain);
    result.insert(result.end(), of_chain.begin(), of_chain.end());
  }
  return result;
}

/// Of a point on none of the face's boundaries.
bool is_in_face(const Point& p, const Component& outline) {
  return winding_number(p, edges(Region{{outline}})) == 1;
}

TEST(FaceDrawing, free_disks_are_in_their_faces_where_the_winding_number_is_that_of_the_face) {
  std::size_t disks = 0;
  for_each_pair_of_shapes([&](const Region& p, const Region& q) {
    const std::vector<ConvolutionSegment> all = traced_convolution(p, q);
    const ConvolutionArrangement arrangement(all);
    const std::vector<int> numbers = winding_numbers(arrangement);
    const FaceDrawing drawing(arrangement);
    for (Face f = 1; f < arrangement.face_count(); ++f) {
      const std::optional<FreeDisk> disk = drawing.free_disk(f);
      if (!disk) continue;
      ++disks;
      ASSERT_GT(disk->squared_radius, 0);
      EXPECT_EQ(winding_number(disk->centre, segments(all)), numbers[f]) << to_string(disk->centre);
      const Component outline = drawing.outline(f);
      const Rational r(0.999 * std::sqrt(disk->squared_radius.get_d()));
      const Rational s = r * 7 / 10;
      for (const Vector& v :
           {Vector{0, 0}, {r, 0}, {-r, 0}, {0, r}, {0, -r}, {s, s}, {s, -s}, {-s, s}, {-s, -s}})
        EXPECT_TRUE(is_in_face(disk->centre + v, outline)) << to_string(disk->centre + v);
    }
  });
  EXPECT_GT(disks, 3000U);
}

TEST(FaceDrawing, a_disk_is_the_largest_where_that_is_easy) {
  const ConvolutionArrangement square = arrangement_of(edges_of({box(0, 0, 4, 4)}));
  const std::optional<FreeDisk> disk = FaceDrawing(square).free_disk(1);
  ASSERT_TRUE(disk);
  EXPECT_EQ(disk->centre, (Point{2, 2}));
  EXPECT_EQ(disk->squared_radius, 4);
}

TEST(FaceDrawing, edges_bound_a_disk_and_their_lines_do_not) {
  const ConvolutionArrangement notched =
      arrangement_of(edges_of({{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 6}, {2, 4}, {0, 2}}}));
  const std::optional<FreeDisk> disk = FaceDrawing(notched).free_disk(1);
  ASSERT_TRUE(disk);
  EXPECT_EQ(disk->centre, (Point{Rational(9, 2), 5}));
  EXPECT_EQ(disk->squared_radius, Rational(29, 4));  // the notch is nearest
}

TEST(FaceDrawing, faces_may_have_holes_antennas_and_touching_boundaries) {
  // A frame around a square, an edge from the frame inwards, one that stands alone, and a triangle
  // that touches the frame.
  std::vector<Segment> all = edges_of(
      {box(0, 0, 12, 12), backwards(box(4, 4, 8, 8)), backwards({{0, 6}, {2, 5}, {2, 7}})});
  for (const Segment& s : {Segment{{6, 0}, {6, 3}}, Segment{{9, 9}, {11, 11}}}) {
    all.push_back(s);
    all.push_back(reversed(s));
  }
  const ConvolutionArrangement arrangement = arrangement_of(all);
  ASSERT_EQ(arrangement.face_count(), 4U);
  const FaceDrawing drawing(arrangement);
  std::multiset<Rational> areas;
  for (Face f = 1; f < 4; ++f) {
    const Component outline = drawing.outline(f);
    areas.insert(area(Region{{outline}}));
    const std::optional<FreeDisk> disk = drawing.free_disk(f);
    ASSERT_TRUE(disk);
    EXPECT_TRUE(is_in_face(disk->centre, outline)) << to_string(disk->centre);
  }
  EXPECT_EQ(areas, (std::multiset<Rational>{2, 16, 144 - 16 - 2}));
}

TEST(FaceDrawing, faces_low_or_narrow_have_no_disk) {
  const auto has_disk = [](const Chain& chain) {
    const ConvolutionArrangement arrangement =
        arrangement_of(edges_of({box(0, 0, 1000, 1000), chain}));
    const FaceDrawing drawing(arrangement);
    for (Face f = 1; f < arrangement.face_count(); ++f) {
      if (area(Region{{drawing.outline(f)}}) < 500 * 500) return drawing.free_disk(f).has_value();
    }
    throw std::logic_error("no such face");
  };
  EXPECT_TRUE(has_disk(box(1, 1, 11, 11)));
  EXPECT_FALSE(has_disk(box(1, 1, 10, 500)));
  EXPECT_FALSE(has_disk(box(1, 1, 500, 10)));
}

TEST(FaceDrawing, nothing_is_no_fault) {
  const ConvolutionArrangement arrangement = arrangement_of({});
  const FaceDrawing drawing(arrangement);
  EXPECT_EQ(arrangement.face_count(), 1U);
}

}  // namespace
}  // namespace oplus
