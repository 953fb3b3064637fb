// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/places/points_beside.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reference/definitions/region.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {
namespace {

TEST(PointsBeside, AreInEveryFaceAndOnNoSegment) {
  // Two squares that overlap in a third: four faces, identified by both winding numbers.
  const Chain a = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Chain b = translated(a, {1, 1});
  std::vector<Segment> segments = edges(a);
  for (const Segment& s : edges(b)) segments.push_back(s);
  std::set<std::pair<int, int>> faces;
  for (const Point& x : points_beside(segments)) {
    for (const Segment& s : segments) EXPECT_FALSE(lies_on(x, s));
    faces.emplace(winding_number(x, edges(a)), winding_number(x, edges(b)));
  }
  EXPECT_EQ(faces.size(), 4U);
}

TEST(PointsBeside, StopBeforeASegmentThatLiesOnTheRay) {
  const std::vector<Segment> segments = {{{0, 0}, {4, 0}}, {{2, 1}, {2, 3}}};
  std::size_t on_ray = 0;
  for (const Point& x : points_beside(segments)) {
    if (x.x != 2 || x.y < 0) continue;
    ++on_ray;
    EXPECT_LT(x.y, 1);
  }
  EXPECT_EQ(on_ray, 1U);
}

TEST(PointsBeside, CountASegmentAndItsReverseAsOnePiece) {
  const Segment s{{0, 0}, {1, 0}};
  EXPECT_EQ(points_beside({s, reversed(s), s}).size(), 2U);
}

}  // namespace
}  // namespace oplus
