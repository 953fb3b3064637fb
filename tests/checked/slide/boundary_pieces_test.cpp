// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/boundary_pieces.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus::slide {
namespace {

/// Each piece from a point of a column to the next but one, and from the end of one to the next column.
TEST(CutAtPoints, does_not_depend_on_the_number_of_threads) {
  std::vector<Point> points;
  std::vector<double> near_x, near_y;
  std::vector<BoundaryPiece> pieces;
  for (int x = 0; x < 150; ++x) {
    for (int y = 0; y < 80; ++y) {
      points.push_back({x, y});
      near_x.push_back(x);
      near_y.push_back(y);
    }
  }
  for (std::uint32_t i = 0; i + 2 < points.size(); ++i) pieces.push_back({i, i + 2, i});
  const auto is_on = [&](std::uint32_t i, const BoundaryPiece& piece) {
    return lies_on(points[i], {points[piece.from], points[piece.to]});
  };
  const auto one = cut_at_points(pieces, {is_on, near_x, near_y}, 1);
  EXPECT_EQ(one.size(), pieces.size() + 150 * 78);
  EXPECT_EQ(cut_at_points(pieces, {is_on, near_x, near_y}, 3), one);
}

}  // namespace
}  // namespace oplus::slide
