// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/points_in_faces.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reference/definitions/region.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {
namespace {

/// Identifies each face by its winding numbers in both chains.
std::multiset<std::pair<int, int>> faces(const Chain& a, const Chain& b,
                                         const std::vector<Segment>& avoided) {
  std::vector<Segment> segments = edges(a);
  for (const Segment& s : edges(b)) segments.push_back(s);
  std::multiset<std::pair<int, int>> result;
  for (const Point& x : points_in_faces(segments, avoided)) {
    for (const Segment& s : segments) EXPECT_FALSE(lies_on(x, s));
    for (const Segment& s : avoided) EXPECT_FALSE(lies_on(x, s));
    result.emplace(winding_number(x, edges(a)), winding_number(x, edges(b)));
  }
  return result;
}

const Chain square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
using Faces = std::multiset<std::pair<int, int>>;

TEST(PointsInFaces, AreOneInEachFaceOfAConnectedArrangement) {
  EXPECT_EQ(faces(square, translated(square, {1, 1}), {}), (Faces{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
}

TEST(PointsInFaces, AreOneForEachPartOfAFacesBoundary) {
  EXPECT_EQ(faces(square, translated(square, {5, 0}), {}), (Faces{{0, 0}, {0, 0}, {0, 1}, {1, 0}}));
}

TEST(PointsInFaces, CountEqualAndReversedSegmentsAsOnePiece) {
  EXPECT_EQ(faces(square, {square.rbegin(), square.rend()}, {}), (Faces{{0, 0}, {1, -1}}));
}

TEST(PointsInFaces, AvoidOtherSegmentsThatCutAFace) {
  // Lines through all points that are half way, so that such a point would be on one of them.
  std::vector<Segment> avoided;
  for (int k = -8; k <= 16; ++k) {
    const Rational at(k, 4);
    avoided.push_back({{at, -4}, {at, 4}});
    avoided.push_back({{-4, at}, {4, at}});
    avoided.push_back({{at - 4, -4}, {at + 4, 4}});
  }
  EXPECT_EQ(faces(square, translated(square, {1, 1}), avoided),
            (Faces{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
}

TEST(PointsInFaces, AreEmptyWithoutSegments) { EXPECT_TRUE(points_in_faces({}, {}).empty()); }

}  // namespace
}  // namespace oplus
