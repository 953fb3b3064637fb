// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/boundary_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/random.hpp"

namespace oplus::slide {

void PrintTo(const BoundaryPiece& piece, std::ostream* out) {
  *out << piece.from << "->" << piece.to << " on " << piece.segment;
}

namespace {

using Pieces = std::vector<BoundaryPiece>;

/// The points have any order; cut_at_points() wants that of the plane.
Pieces cut_at(const std::vector<Point>& points, const Pieces& pieces, unsigned threads = 1) {
  std::vector<std::uint32_t> in_order(points.size()), place(points.size());
  std::iota(in_order.begin(), in_order.end(), 0);
  std::sort(in_order.begin(), in_order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  std::vector<double> near_x, near_y;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    place[in_order[k]] = k;
    near_x.push_back(points[in_order[k]].x.get_d());
    near_y.push_back(points[in_order[k]].y.get_d());
  }
  const auto renamed = [](Pieces all, const std::vector<std::uint32_t>& names) {
    for (BoundaryPiece& piece : all) piece = {names[piece.from], names[piece.to], piece.segment};
    return all;
  };
  const auto point = [&](std::uint32_t k) { return points[in_order[k]]; };
  const auto is_on = [&](std::uint32_t i, const BoundaryPiece& piece) {
    return lies_on(point(i), {point(piece.from), point(piece.to)});
  };
  const Pieces cut = cut_at_points(renamed(pieces, place), {is_on, near_x, near_y}, threads);
  EXPECT_TRUE(std::is_sorted(cut.begin(), cut.end()));
  Pieces result = renamed(cut, in_order);
  std::sort(result.begin(), result.end());
  return result;
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

TEST(CutAtPoints, sees_detail_beside_points_that_are_far_away) {
  const Rational far(mpz_class(1) << 100);
  const std::vector<Point> points{{0, 0}, {2, 0}, {1, 0}, {far, far}, {-far, 0}, {1, 1}};
  EXPECT_EQ(cut_at(points, {{0, 1, 0}}), (Pieces{{0, 2, 0}, {2, 1, 0}}));
  EXPECT_EQ(cut_at(points, {{4, 0, 0}, {0, 3, 1}}), (Pieces{{0, 5, 1}, {4, 0, 0}, {5, 3, 1}}));
}

TEST(CutAtPoints, does_not_depend_on_the_number_of_threads) {
  std::vector<Point> points;
  for (int i = 0; i < 150; ++i)
    for (int j = 0; j < 80; ++j) points.push_back({i, j});
  Pieces pieces;
  for (std::uint32_t i = 0; i + 2 < points.size(); ++i) pieces.push_back({i, i + 2, i});
  const Pieces one = cut_at(points, pieces);
  EXPECT_GT(one.size(), pieces.size() + 9000);
  EXPECT_EQ(cut_at(points, pieces, 3), one);
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
