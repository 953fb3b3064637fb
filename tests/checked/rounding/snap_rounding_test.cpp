// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/rounding/snap_rounding.hpp"

#include <CGAL/Cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Snap_rounding_2.h>
#include <CGAL/Snap_rounding_traits_2.h>
#include <gtest/gtest.h>

#include <list>

#include "reference/families/random.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

TEST(NearestMultiple, of_a_number_between_two_is_the_larger_one) {
  EXPECT_EQ(nearest_multiple(Rational(1, 2), 1), 1);
  EXPECT_EQ(nearest_multiple(Rational(-1, 2), 1), 0);
  EXPECT_EQ(nearest_multiple(Rational(-51, 100), 1), -1);
  EXPECT_EQ(nearest_multiple(10, 3), 9);
  EXPECT_EQ(nearest_multiple(Rational(1, 3), Rational(1, 100)), Rational(33, 100));
  EXPECT_TRUE(is_on_grid({Rational(3, 10), -7}, Rational(1, 10)));
  EXPECT_FALSE(is_on_grid({Rational(3, 10), Rational(1, 3)}, Rational(1, 10)));
}

using Points = std::vector<Point>;

TEST(HotPixels, has_left_and_lower_sides_only) {
  const Rational half(1, 2);
  const HotPixels hot({{0, 0}}, 1);
  EXPECT_EQ(hot.passed({{-half, -5}, {-half, 5}}), Points({{0, 0}}));
  EXPECT_EQ(hot.passed({{half, -5}, {half, 5}}), Points());
  EXPECT_EQ(hot.passed({{-5, -half}, {5, -half}}), Points({{0, 0}}));
  EXPECT_EQ(hot.passed({{-5, half}, {5, half}}), Points());
  const Rational beyond = -half - Rational(1, mpz_class(1) << 80);  // -half in doubles
  EXPECT_EQ(hot.passed({{beyond, -5}, {beyond, 5}}), Points());
  // Corners: the lower left one only.
  EXPECT_EQ(hot.passed({{-1, 0}, {0, -1}}), Points({{0, 0}}));
  EXPECT_EQ(hot.passed({{1, 0}, {0, 1}}), Points());
  EXPECT_EQ(hot.passed({{-1, 0}, {0, 1}}), Points());
  EXPECT_EQ(hot.passed({{1, 0}, {0, -1}}), Points());
}

TEST(HotPixels, are_passed_in_order) {
  const Points all = {{0, 0}, {1, 0}, {2, 1}, {3, 1}, {2, 5}};
  const HotPixels hot(all, 1);
  EXPECT_EQ(hot.passed({{0, 0}, {3, 1}}), Points({{0, 0}, {1, 0}, {2, 1}, {3, 1}}));
  EXPECT_EQ(hot.passed({{3, 1}, {0, 0}}), Points({{3, 1}, {2, 1}, {1, 0}, {0, 0}}));
  EXPECT_EQ(hot.passed({{2, 5}, {2, 1}}), Points({{2, 5}, {2, 1}}));
}

/// Points where CGAL has doubles on its way, and would take forever.
TEST(HotPixels, may_be_as_small_as_they_like) {
  const Rational step = Rational(1) / mpz_class("1000000000000000000000000000000");
  const HotPixels hot({{Rational(1, 3), 0}, {1000, Rational(1, 7)}}, step);
  const Points passed = hot.passed({{Rational(1, 3), 0}, {1000, Rational(1, 7)}});
  ASSERT_EQ(passed.size(), 2U);
  EXPECT_TRUE(abs(passed[0].x - Rational(1, 3)) <= step / 2);
}

/// CGAL's snap rounding, not iterated; its pixels are centred on odd multiples of half a step.
std::vector<Points> by_cgal(const std::vector<Segment>& segments, const Rational& step) {
  using Kernel = CGAL::Cartesian<CGAL::Gmpq>;
  using Traits = CGAL::Snap_rounding_traits_2<Kernel>;
  const auto number = [&](const Rational& value) {
    const Rational moved = value + step / 2;
    return CGAL::Gmpq(moved.get_mpq_t());
  };
  const auto point = [&](const Point& p) { return Kernel::Point_2(number(p.x), number(p.y)); };
  std::list<Kernel::Segment_2> in;
  for (const Segment& s : segments) in.emplace_back(point(s.source), point(s.target));
  std::list<std::list<Kernel::Point_2>> out;
  CGAL::snap_rounding_2<Traits>(in.begin(), in.end(), out, CGAL::Gmpq(step.get_mpq_t()), false,
                                false);
  std::vector<Points> result;
  for (const std::list<Kernel::Point_2>& polyline : out) {
    Points points;
    for (const Kernel::Point_2& p : polyline) {
      const auto back = [&](const CGAL::Gmpq& value) -> Rational {
        return Rational(value.mpq()) - step / 2;
      };
      points.push_back({back(p.x()), back(p.y())});
    }
    result.push_back(std::move(points));
  }
  return result;
}

/// On a grid four times as fine, so that segments run along sides of pixels and through their corners.
TEST(HotPixels, are_those_that_cgal_finds) {
  Random random(20);
  std::size_t bent = 0;
  for (int round = 0; round < 100; ++round) {
    // Two fans, whose segments meet in ends only, and far from each other.
    std::vector<Segment> segments;
    Points points;
    for (const int far : {0, 1000}) {
      const Point centre{Rational(far), 0};
      std::vector<Point> ends;
      for (int i = 0; i < 8; ++i) {
        Rational right(uniform(random, 1, 30), 4);
        Rational up(uniform(random, -30, 30), 4);
        right.canonicalize();
        up.canonicalize();
        ends.push_back({centre.x + right, up});
      }
      for (const Point& end : ends) {
        // One of each direction.
        const bool is_new = std::ranges::none_of(segments, [&](const Segment& s) {
          return sgn(cross(direction_of(s), end - centre)) == 0 && s.source == centre;
        });
        if (is_new) segments.push_back({centre, end});
      }
    }
    for (const Segment& s : segments) points.insert(points.end(), {s.source, s.target});
    const HotPixels hot(points, 1);
    const std::vector<Points> theirs = by_cgal(segments, 1);
    ASSERT_EQ(theirs.size(), segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
      Points ours = hot.passed(segments[i]);
      bent += ours.size() > 2;
      EXPECT_EQ(ours, theirs[i]) << round;
    }
  }
  EXPECT_GT(bent, 50U);
}

}  // namespace
}  // namespace oplus
