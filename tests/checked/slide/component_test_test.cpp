// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/component_test.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "reference/definitions/collision.hpp"
#include "reference/families/polygons.hpp"
#include "reference/families/rich_regions.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers>
class ComponentTestIn : public testing::Test {};
TYPED_TEST_SUITE(ComponentTestIn, AllNumbers);

template <typename Numbers>
bool is_needed(const Region& p, const Region& q) {
  const IntegerSummands<Numbers> both(p, q, scaling_of(p, q));
  return ComponentTest<Numbers>(both).is_needed();
}

/// Whether components of P and -Q + x(n / d) overlap, for a segment that need not be of the
/// convolution.
template <typename Numbers>
bool overlap_at(const Region& p, const Region& q, const Segment& segment, const mpz_class& n,
                const mpz_class& d) {
  const Scaling scaling = scaling_of(p, q);
  IntegerSummands<Numbers> both(p, q, scaling);
  both.prepare_component_test();
  const IntegerSegment<Numbers> exact = integer_segment<Numbers>(segment);
  return ComponentTest<Numbers>(both).overlap_at(track_on(exact, scaling), fraction<Numbers>(n, d));
}

/// Either way round.
template <typename Numbers>
void expect_overlap(bool expected, const Region& p, const Region& q, const Segment& segment,
                    int n = 0, int d = 1) {
  EXPECT_EQ(overlap_at<Numbers>(p, q, segment, n, d), expected);
  EXPECT_EQ(overlap_at<Numbers>(q, p, segment, n, d), expected) << "exchanged";
}

template <typename Numbers>
void expect_overlap(bool expected, const Region& p, const Region& q, const Point& x) {
  expect_overlap<Numbers>(expected, p, q, Segment{x, x + Vector{1, 0}});
}

TYPED_TEST(ComponentTestIn, is_needed_where_there_are_several) {
  const Region one{{{box(0, 0, 5, 5), {backwards(box(1, 1, 4, 4))}}}};
  const Region two{{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, 1), {}}}};
  EXPECT_FALSE(is_needed<TypeParam>(one, one));
  EXPECT_TRUE(is_needed<TypeParam>(one, two));
  EXPECT_TRUE(is_needed<TypeParam>(two, one));
}

TYPED_TEST(ComponentTestIn, sees_one_inside_the_other_in_both_orders) {
  const Region large = polygon(box(0, 0, 10, 10)), small = polygon(box(0, 0, 1, 1));
  // -Q + x is x - 1 to x; then x - 10 to x.
  expect_overlap<TypeParam>(true, large, small, Point{5, 5});
  for (const Point& outside : {Point{-3, 5}, Point{15, 5}, Point{5, -3}, Point{5, 15}})
    expect_overlap<TypeParam>(false, large, small, outside);
}

TYPED_TEST(ComponentTestIn, sees_none_in_a_hole) {
  const Region frame{{{box(0, 0, 10, 10), {backwards(box(2, 2, 8, 8))}}}};
  expect_overlap<TypeParam>(false, frame, polygon(box(0, 0, 1, 1)), Point{5, 5});
  // Islands in the hole, the first component or the last.
  const Component island{box(4, 4, 7, 7), {}};
  const Region tiny = polygon({{0, 0}, {1, 0}, {0, 1}});
  for (const Region& region :
       {Region{{frame.components[0], island}}, Region{{island, frame.components[0]}}}) {
    expect_overlap<TypeParam>(true, region, tiny, Point{6, 6});
    expect_overlap<TypeParam>(false, region, tiny, Point{4, 4});
  }
}

TYPED_TEST(ComponentTestIn, looks_at_every_pair_of_components) {
  const Region p{{{box(0, 0, 1, 1), {}}, {box(10, 0, 11, 1), {}}, {box(20, 0, 29, 9), {}}}};
  const Region q{{{box(0, 0, 1, 1), {}}, {box(0, 40, 1, 41), {}}}};
  expect_overlap<TypeParam>(true, p, q, Point{25, 5});   // the last and the first
  expect_overlap<TypeParam>(true, p, q, Point{25, 45});  // the last and the last
  expect_overlap<TypeParam>(false, p, q, Point{25, 25});
  expect_overlap<TypeParam>(false, p, q, Point{15, 45});
}

TYPED_TEST(ComponentTestIn, counts_vertices_level_with_each_other_once) {
  // To the right of (0, 4): a vertex that the ray passes, one that it touches, and an edge along it.
  const Region p =
      region_from(
          "POLYGON ((-9 -9, 30 -9, 20 4, 30 9, 18 9, 16 4, 14 9, 10 9, 8 4, 6 4, 5 9, -9 9, -9 -9))")
          .region;
  const Region q = polygon({{0, 0}, {1, 0}, {0, 1}});
  for (const Vector& along : {Vector{1, 0}, Vector{-1, 0}, Vector{0, 1}, Vector{0, -1},
                              Vector{1, 1}, Vector{-2, 1}, Vector{1, -1}, Vector{-1, -1}}) {
    expect_overlap<TypeParam>(true, p, q, Segment{{0, 4}, Point{0, 4} + along});
    expect_overlap<TypeParam>(false, p, q, Segment{{-12, 4}, Point{-12, 4} + along});
  }
}

TYPED_TEST(ComponentTestIn, comes_apart_to_the_right_where_a_vertex_slides_along_an_edge) {
  const Region square = polygon(box(0, 0, 10, 10));
  // -Q is to the left of x, and to the right of it.
  const Region pointing_right = polygon({{0, 0}, {2, -1}, {2, 1}});
  const Region pointing_left = polygon({{0, 0}, {-2, 1}, {-2, -1}});
  const Segment down_the_right_side{{10, 5}, {10, 4}}, up_the_right_side{{10, 5}, {10, 6}};
  const Segment down_the_left_side{{0, 5}, {0, 4}}, up_the_left_side{{0, 5}, {0, 6}};
  for (int times = 0; times < 4; ++times) {
    SCOPED_TRACE(times);
    const AffineMap turned = quarter_turns(times);
    const auto expect = [&](bool expected, const Region& q, const Segment& slid) {
      expect_overlap<TypeParam>(expected, image(turned, square), image(turned, q),
                                image(turned, slid));
    };
    expect(true, pointing_right, down_the_right_side);
    expect(false, pointing_left, up_the_right_side);
    expect(true, pointing_left, up_the_left_side);
    expect(false, pointing_right, down_the_left_side);
  }
}

/// Whether a pair of edges has a point in common.
bool edges_meet(const Region& a, const Region& b) {
  for (const Segment& e : edges(a))
    for (const Segment& f : edges(b))
      if (!intersection(e, f).empty()) return true;
  return false;
}

TEST(ComponentTest, tells_whether_the_interiors_meet_where_no_edges_do) {
  Random random(15);
  const Vector directions[] = {{1, 0},  {-1, 0}, {0, 2},   {0, -1}, {1, 1},
                               {-1, 1}, {1, -2}, {-3, -1}, {2, 1},  {-1, -1}};
  std::size_t overlapping = 0, apart = 0, touching = 0;
  for (int k = 0; k < 800; ++k) {
    const Region p = one_in(random, 2) ? scattered_region(random, 5) : holed_region(random, 5);
    const Region q = one_in(random, 2) ? scattered_region(random, 4) : plain_region(random, 4);
    // Large enough that the other finds room inside.
    const int factor = one_in(random, 2) ? 4 : 1;
    const Region large = image(scaling(factor), p);
    const int x = uniform(random, -2, 6 * factor), y = uniform(random, -2, 6 * factor);
    const Vector d = directions[uniform_index(random, std::size(directions))];
    const Segment segment{{x, y}, Point{x, y} + d};
    const int denominator = uniform(random, 1, 3), numerator = uniform(random, 0, denominator);
    const Rational t = Rational(numerator) / denominator;
    // Infinitesimals that small integers can't tell from real ones.
    const Point exact = segment.source + t * d;
    const Rational little(1, 1000000);
    const Point shifted = exact + little * d + little * little * Vector{d.y, -d.x};
    const Region minus_q = translated(reflected(q), shifted);
    if (edges_meet(large, minus_q)) continue;
    const bool expected = interiors_meet(large, minus_q);
    ++(expected ? overlapping : apart);
    touching += edges_meet(large, translated(reflected(q), exact)) ? 1 : 0;
    SCOPED_TRACE(k);
    expect_overlap<SmallNumbers>(expected, large, q, segment, numerator, denominator);
    expect_overlap<WideNumbers>(expected, large, q, segment, numerator, denominator);
    expect_overlap<AnyNumbers>(expected, large, q, segment, numerator, denominator);
  }
  EXPECT_GT(overlapping, 20u);
  EXPECT_GT(apart, 200u);
  EXPECT_GT(touching, 20u);
}

TYPED_TEST(ComponentTestIn, locates_places_in_long_chains) {
  Random random(16);
  const int size = 2'000'000;
  const Component square{box(2 * size, 0, 2 * size + 1, 1), {}};
  const Region tiny = polygon({{0, 0}, {1, 0}, {0, 1}});
  std::size_t inside = 0, outside = 0;
  for (int k = 0; k < 5; ++k) {
    // A star, or a frame around one; and a component far away.
    Region p = star_polygon(random, 60);
    if (k % 2 == 0) p = {{{box(-size, -size, size, size), {backwards(p.components[0].outer)}}}};
    p.components.insert(one_in(random, 2) ? p.components.begin() : p.components.end(), square);
    for (int places = 0; places < 100; ++places) {
      const Point x{uniform(random, -size, size), uniform(random, -size, size)};
      const Region minus_q = translated(reflected(tiny), x + Vector{0, Rational(1, 1000)});
      if (edges_meet(p, minus_q)) continue;
      const bool expected = interiors_meet(p, minus_q);
      ++(expected ? inside : outside);
      expect_overlap<TypeParam>(expected, p, tiny, x);
    }
  }
  EXPECT_GT(inside, 20u);
  EXPECT_GT(outside, 20u);
}

template <typename Numbers>
class ComponentTestAtTheLimit : public testing::Test {};
TYPED_TEST_SUITE(ComponentTestAtTheLimit, LimitedNumbers);

TYPED_TEST(ComponentTestAtTheLimit, is_that_of_gmp) {
  const Rational m = power_of_two(TypeParam::bits) - 1;
  const Region halves{
      {{{{2 - m, -m}, {m, -m}, {m, m - 2}}, {}}, {{{-m, 2 - m}, {m - 2, m}, {-m, m}}, {}}}};
  const Region needle = polygon({{-m, -m}, {m, m - 1}, {m, m}});
  // Denominators are at most the sum of two areas of parallelograms.
  const mpz_class d = 16 * m.get_num() * m.get_num() - 1;
  std::size_t overlapping = 0;
  for (int turns_of_q = 0; turns_of_q < 4; ++turns_of_q) {
    for (const auto& [p, q] : {std::pair{halves, needle}, {needle, halves}, {needle, needle}}) {
      const Region turned_q = image(quarter_turns(turns_of_q), q);
      for (const Segment& edge : edges(p)) {
        for (const Point& vertex : turned_q.components[0].outer) {
          const Segment segment{edge.source + vertex, edge.target + vertex};
          for (const mpz_class& n : {mpz_class(1), mpz_class(d / 3), mpz_class(d - 1)}) {
            const bool expected = overlap_at<AnyNumbers>(p, turned_q, segment, n, d);
            EXPECT_EQ(overlap_at<TypeParam>(p, turned_q, segment, n, d), expected);
            overlapping += expected ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(overlapping, 10u);
}

}  // namespace
}  // namespace oplus::slide
