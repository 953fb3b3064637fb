// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/boundary_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/random.hpp"

namespace oplus::slide {

void PrintTo(const BoundaryPiece& piece, std::ostream* out) {
  *out << piece.from << "->" << piece.to << " on " << piece.segment;
}

namespace {

using Pieces = std::vector<BoundaryPiece>;

constexpr double margin = 0x1p-30;

Pieces cut_at(const std::vector<Point>& points, const Pieces& pieces) {
  std::vector<double> near_x, near_y;
  for (const Point& p : points) {
    near_x.push_back(p.x.get_d());
    near_y.push_back(p.y.get_d());
  }
  const auto is_on = [&](std::uint32_t i, const BoundaryPiece& piece) {
    return lies_on(points[i], {points[piece.from], points[piece.to]});
  };
  return cut_at_points(pieces,
                       {[&](std::uint32_t i) { return points[i]; }, is_on, near_x, near_y, margin});
}

TEST(CutAtPoints, leaves_what_has_no_point_inside) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {2, 1}, {6, 0}, {-1, 0}};
  EXPECT_EQ(cut_at(points, {{0, 1, 7}}), (Pieces{{0, 1, 7}})) << "beside it, and on its line";
  EXPECT_EQ(cut_at(points, {{2, 3, 1}, {0, 1, 7}}), (Pieces{{0, 1, 7}, {2, 3, 1}})) << "sorted";
  EXPECT_EQ(cut_at(points, {}), Pieces{});
}

TEST(CutAtPoints, cuts_in_the_direction_of_the_piece) {
  const std::vector<Point> points{{0, 0}, {3, 3}, {1, 1}, {2, 2}, {2, 1}};
  EXPECT_EQ(cut_at(points, {{0, 1, 5}}), (Pieces{{0, 2, 5}, {2, 3, 5}, {3, 1, 5}}));
  EXPECT_EQ(cut_at(points, {{1, 0, 5}}), (Pieces{{1, 3, 5}, {2, 0, 5}, {3, 2, 5}}));
  const std::vector<Point> upright{{1, 9}, {1, 0}, {1, 4}, {1, 8}};
  EXPECT_EQ(cut_at(upright, {{0, 1, 2}}), (Pieces{{0, 3, 2}, {2, 1, 2}, {3, 2, 2}}));
}

TEST(CutAtPoints, makes_equal_pieces_of_what_overlaps) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {4, 0}, {6, 0}};
  EXPECT_EQ(cut_at(points, {{0, 2, 0}, {1, 3, 1}}),
            (Pieces{{0, 1, 0}, {1, 2, 0}, {1, 2, 1}, {2, 3, 1}}));
}

TEST(CutAtPoints, is_exact_where_doubles_are_not) {
  // All doubles are those of (1/2, 1/2), but only one of these points is on the diagonal.
  const Rational half(1, 2), little(1, mpz_class(1) << 200);
  const std::vector<Point> points{
      {0, 0}, {1, 1}, {half, half + little}, {half, half - little}, {half + little, half + little}};
  EXPECT_EQ(cut_at(points, {{0, 1, 0}}), (Pieces{{0, 4, 0}, {4, 1, 0}}));
  const std::vector<Point> two{{0, 0}, {1, 1}, {half, half}, {half - little, half - little}};
  EXPECT_EQ(cut_at(two, {{0, 1, 0}}), (Pieces{{0, 3, 0}, {2, 1, 0}, {3, 2, 0}}));
  // Just behind an end, and in front of it.
  const std::vector<Point> ends{{0, 0}, {1, 1}, {-little, -little}, {1 - little, 1 - little}};
  EXPECT_EQ(cut_at(ends, {{0, 1, 0}}), (Pieces{{0, 3, 0}, {3, 1, 0}}));
}

TEST(CutAtPoints, cuts_at_all_points_and_no_others) {
  Random random(10);
  for (int k = 0; k < 150; ++k) {
    std::vector<Point> points;
    const int side = uniform(random, 2, 6);
    for (int x = 0; x < side; ++x)
      for (int y = 0; y < side; ++y)
        if (!one_in(random, 3)) points.push_back({Rational(x) / 3, Rational(y) / 7});
    if (points.size() < 2) continue;
    Pieces pieces, expected;
    for (std::uint32_t segment = 0; segment < 10; ++segment) {
      const auto from = static_cast<std::uint32_t>(uniform_index(random, points.size()));
      const auto to = static_cast<std::uint32_t>(uniform_index(random, points.size()));
      if (from == to) continue;
      pieces.push_back({from, to, segment});
      const auto name = [&](const Point& p) {
        return static_cast<std::uint32_t>(std::find(points.begin(), points.end(), p) -
                                          points.begin());
      };
      for (const Segment& s : cut({points[from], points[to]}, points))
        expected.push_back({name(s.source), name(s.target), segment});
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(cut_at(points, pieces), expected);
  }
}

}  // namespace
}  // namespace oplus::slide
