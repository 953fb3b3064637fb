// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/named_ends.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers>
class NamedEndsIn : public testing::Test {};
TYPED_TEST_SUITE(NamedEndsIn, AllNumbers);

/// Names the ends of pieces from k / 7 to (k + 1) / 7 of all segments, in fractions that are not reduced,
/// and compares them with the points as rationals.
template <typename Numbers>
void expect_names(const Region& p, const Region& q, Random& random) {
  const Scaling scaling = scaling_of(extent_of(p), extent_of(q));
  const ReducedSegments<Numbers> segments(p, q, scaling);
  const auto place = [&](long n) {
    const mpz_class by = odd_number(
        random, static_cast<unsigned>(uniform(random, 1, static_cast<int>(bits<Numbers>) - 4)));
    return fraction<Numbers>(n * by, 7 * by);
  };
  ShortList<FreePiece<Numbers>> pieces;
  for (std::uint32_t segment = 0; segment < segments.size(); ++segment)
    for (long n = 0; n < 7; ++n) pieces.push_back({segment, {place(n), place(n + 1)}});
  const NamedEnds<Numbers> named = named_ends(pieces, segments, scaling, 1);

  std::set<Point> points;
  ASSERT_EQ(named.pieces.size(), pieces.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    EXPECT_EQ(named.pieces[k].segment, pieces[k].segment);
    const Segment segment = in_the_plane(segments[pieces[k].segment], scaling);
    const auto expect_name = [&](std::uint32_t name, const Fraction<Numbers>& t) {
      Point x = segment.source + place_of(t) * direction_of(segment);
      EXPECT_EQ(named.points[name].in_the_plane(scaling), x);
      points.insert(std::move(x));
    };
    expect_name(named.pieces[k].from, pieces[k].piece.from);
    expect_name(named.pieces[k].to, pieces[k].piece.to);
  }
  EXPECT_EQ(named.points.size(), points.size());
  std::size_t name = 0;
  for (const Point& x : points) {
    EXPECT_EQ(named.points[name].in_the_plane(scaling), x);
    const auto expect_near = [&](double near, const Rational& c, const mpz_class& offset) {
      const Rational exact = c * scaling.denominator - offset;
      EXPECT_LE(abs(near * power_of_two(static_cast<int>(scaling.shift)) - exact),
                power_of_two(-50) * abs(exact));
    };
    expect_near(named.near_x[name], x.x, scaling.of_p.x + scaling.of_q.x);
    expect_near(named.near_y[name], x.y, scaling.of_p.y + scaling.of_q.y);
    ++name;
  }
}

TYPED_TEST(NamedEndsIn, are_in_the_order_of_the_plane_whatever_fractions_say_where) {
  Random random(1);
  for (const Rational& size : {Rational(4), power_of_two(is_small<TypeParam> ? 27 : 59)})
    for (int k = 0; k < 20; ++k)
      expect_names<TypeParam>(polygon(box(-size, 0, size, size)),
                              polygon(box(1 - size, 1, size / 2, size - 1)), random);
}

}  // namespace
}  // namespace oplus::slide
