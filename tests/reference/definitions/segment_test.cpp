// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/segment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

/// All directed segments between points of a 3x3 grid.
std::vector<Segment> grid_segments() {
  std::vector<Point> points;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y) points.push_back({x, y});
  std::vector<Segment> all;
  for (const Point& p : points)
    for (const Point& q : points)
      if (p != q) all.push_back({p, q});
  return all;
}

/// Where on a segment's line a point of it lies: 0 at the source, 1 at the target.
Rational parameter(const Point& p, const Segment& s) {
  return dot(p - s.source, direction_of(s)) / dot(direction_of(s), direction_of(s));
}

/// The parameters on a and b at which two lines cross that are not parallel.
struct LineCrossing {
  Rational on_a, on_b;
  bool on_both() const { return 0 <= on_a && on_a <= 1 && 0 <= on_b && on_b <= 1; }
  bool inside_both() const { return 0 < on_a && on_a < 1 && 0 < on_b && on_b < 1; }
};

std::optional<LineCrossing> line_crossing(const Segment& a, const Segment& b) {
  const Vector u = direction_of(a);
  const Vector v = direction_of(b);
  const Rational across = u.x * v.y - u.y * v.x;
  if (across == 0) return std::nullopt;
  const Vector w = b.source - a.source;
  return LineCrossing{(w.x * v.y - w.y * v.x) / across, (w.x * u.y - w.y * u.x) / across};
}

/// The intersection by parameters, not by orientations.
std::vector<Point> naive_intersection(const Segment& a, const Segment& b) {
  if (const auto crossing = line_crossing(a, b)) {
    if (!crossing->on_both()) return {};
    return {a.source + crossing->on_a * direction_of(a)};
  }
  const Vector u = direction_of(a);
  const Vector w = b.source - a.source;
  if (u.x * w.y != u.y * w.x) return {};
  Rational low = parameter(b.source, a);
  Rational high = parameter(b.target, a);
  if (high < low) std::swap(low, high);
  low = std::max<Rational>(low, 0);
  high = std::min<Rational>(high, 1);
  if (high < low) return {};
  std::vector<Point> ends{a.source + low * u};
  if (low < high) ends.push_back(a.source + high * u);
  std::sort(ends.begin(), ends.end());
  return ends;
}

TEST(Segment, intersection_is_that_by_parameters_for_all_pairs_on_a_grid) {
  for (const Segment& a : grid_segments())
    for (const Segment& b : grid_segments())
      ASSERT_EQ(intersection(a, b), naive_intersection(a, b))
          << testing::PrintToString(a) << " and " << testing::PrintToString(b);
}

TEST(Segment, cross_properly_is_that_by_parameters_for_all_pairs_on_a_grid) {
  for (const Segment& a : grid_segments()) {
    for (const Segment& b : grid_segments()) {
      const auto crossing = line_crossing(a, b);
      ASSERT_EQ(cross_properly(a, b), crossing && crossing->inside_both())
          << testing::PrintToString(a) << " and " << testing::PrintToString(b);
    }
  }
}

TEST(Segment, maximal_segments_join_what_is_collinear_and_shares_a_point) {
  const std::vector<Segment> given{
      {{2, 0}, {1, 0}}, {{0, 0}, {1, 0}},                    // touch, one of them reversed
      {{5, 0}, {8, 0}}, {{6, 0}, {9, 0}}, {{7, 0}, {8, 0}},  // overlapping and contained
      {{1, 0}, {1, 3}},                                      // crosses
      {{0, 1}, {2, 1}},                                      // parallel
  };
  EXPECT_EQ(maximal_segments(given),
            (std::vector<Segment>{
                {{0, 0}, {2, 0}}, {{0, 1}, {2, 1}}, {{1, 0}, {1, 3}}, {{5, 0}, {9, 0}}}));
}

TEST(Segment, maximal_segments_of_vertical_lines_and_of_points) {
  const std::vector<Segment> given{{{1, 5}, {1, 3}}, {{1, 1}, {1, 3}}, {{2, 4}, {2, 3}},
                                   {{1, 2}, {1, 2}}, {{1, 6}, {1, 6}}, {{1, 6}, {1, 6}}};
  EXPECT_EQ(maximal_segments(given),
            (std::vector<Segment>{{{1, 1}, {1, 5}}, {{1, 6}, {1, 6}}, {{2, 3}, {2, 4}}}));
}

}  // namespace
}  // namespace oplus
