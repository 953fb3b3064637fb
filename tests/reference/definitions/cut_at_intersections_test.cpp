// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/cut_at_intersections.hpp"

#include <gtest/gtest.h>

namespace oplus {
namespace {

TEST(CutAtIntersections, CutsCrossingSegmentsInTheirDirections) {
  const Segment right{{0, 0}, {2, 0}}, down{{1, 1}, {1, -1}};
  const auto pieces = cut_at_intersections({right, down});
  EXPECT_EQ(pieces[0], (std::vector<Segment>{{{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}}));
  EXPECT_EQ(pieces[1], (std::vector<Segment>{{{1, 1}, {1, 0}}, {{1, 0}, {1, -1}}}));
}

TEST(CutAtIntersections, MakesOverlappingSegmentsShareAPiece) {
  const auto pieces = cut_at_intersections({{{0, 0}, {2, 0}}, {{3, 0}, {1, 0}}});
  ASSERT_EQ(pieces[0].size(), 2U);
  ASSERT_EQ(pieces[1].size(), 2U);
  EXPECT_EQ(pieces[0][1], reversed(pieces[1][1]));
}

TEST(CutAtIntersections, LeavesSegmentsThatShareEndsOnly) {
  const auto pieces = cut_at_intersections({{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}});
  EXPECT_EQ(pieces[0].size(), 1U);
  EXPECT_EQ(pieces[1].size(), 1U);
}

TEST(CutAtIntersections, CutsOneSegmentWhereItMeetsOthers) {
  const std::vector<Segment> others = {{{1, -1}, {1, 1}}, {{2, 0}, {2, 5}}, {{0, 0}, {0, 1}}};
  EXPECT_EQ(cut_where_met({{3, 0}, {0, 0}}, others),
            (std::vector<Segment>{{{3, 0}, {2, 0}}, {{2, 0}, {1, 0}}, {{1, 0}, {0, 0}}}));
  EXPECT_EQ(cut_where_met({{3, 0}, {0, 0}}, {}), (std::vector<Segment>{{{3, 0}, {0, 0}}}));
}

}  // namespace
}  // namespace oplus
