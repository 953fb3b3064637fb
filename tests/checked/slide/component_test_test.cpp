// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/component_test.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "reference/definitions/collision.hpp"
#include "reference/families/rich_regions.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers>
class ComponentTestIn : public testing::Test {
 public:
  /// Whether components of P and -Q + x(t) overlap, for a segment that need not be of the
  /// convolution.
  static bool overlap_at(const Region& p, const Region& q, const Segment& segment, int n, int d) {
    const Scaling scaling = scaling_of(p, q);
    const IntegerSummands<Numbers> both = summands(p, q, scaling);
    const IntegerSegment<Numbers> exact = integer_segment<Numbers>(segment);
    return ComponentTest<Numbers>(both).overlap_at({exact, near(exact, scaling)}, {n, d});
  }

  static bool is_needed(const Region& p, const Region& q) {
    const IntegerSummands<Numbers> both = summands(p, q, scaling_of(p, q));
    return ComponentTest<Numbers>(both).is_needed();
  }

  static bool overlap_at(const Region& p, const Region& q, const Point& x) {
    return overlap_at(p, q, {x, x + Vector{1, 0}}, 0, 1);
  }

  static IntegerSummands<Numbers> summands(const Region& p, const Region& q,
                                           const Scaling& scaling) {
    auto of_p = integer_summand<Numbers>(p, scaling, scaling.of_p);
    auto of_q = integer_summand<Numbers>(q, scaling, scaling.of_q);
    BoxTree tree_of_p = box_tree(of_p), tree_of_q = box_tree(of_q);
    return {std::move(of_p), std::move(of_q), std::move(tree_of_p), std::move(tree_of_q),
            margins(scaling)};
  }
};
TYPED_TEST_SUITE(ComponentTestIn, AllNumbers);

TYPED_TEST(ComponentTestIn, is_needed_where_there_are_several) {
  using In = ComponentTestIn<TypeParam>;
  const Region one{{{box(0, 0, 5, 5), {backwards(box(1, 1, 4, 4))}}}};
  const Region two{{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, 1), {}}}};
  EXPECT_FALSE(In::is_needed(one, one));
  EXPECT_TRUE(In::is_needed(one, two));
  EXPECT_TRUE(In::is_needed(two, one));
}

TYPED_TEST(ComponentTestIn, sees_one_inside_the_other_in_both_orders) {
  using In = ComponentTestIn<TypeParam>;
  const Region large = polygon(box(0, 0, 10, 10)), small = polygon(box(0, 0, 1, 1));
  // -Q + x is x - 1 to x; then x - 10 to x.
  EXPECT_TRUE(In::overlap_at(large, small, {5, 5}));
  EXPECT_TRUE(In::overlap_at(small, large, {5, 5}));
  for (const Point& outside : {Point{-3, 5}, Point{15, 5}, Point{5, -3}, Point{5, 15}}) {
    EXPECT_FALSE(In::overlap_at(large, small, outside));
    EXPECT_FALSE(In::overlap_at(small, large, outside));
  }
}

TYPED_TEST(ComponentTestIn, sees_none_in_a_hole) {
  using In = ComponentTestIn<TypeParam>;
  const Region frame{{{box(0, 0, 10, 10), {backwards(box(2, 2, 8, 8))}}}};
  const Region small = polygon(box(0, 0, 1, 1));
  EXPECT_FALSE(In::overlap_at(frame, small, {5, 5}));
  EXPECT_FALSE(In::overlap_at(small, frame, {5, 5}));
  // Islands in the hole, the first component or the last.
  const Component island{box(4, 4, 7, 7), {}};
  for (const Region& region :
       {Region{{frame.components[0], island}}, Region{{island, frame.components[0]}}}) {
    const Region tiny = polygon({{0, 0}, {1, 0}, {0, 1}});
    EXPECT_TRUE(In::overlap_at(region, tiny, {6, 6}));
    EXPECT_TRUE(In::overlap_at(tiny, region, {6, 6}));
    EXPECT_FALSE(In::overlap_at(region, tiny, {4, 4}));
    EXPECT_FALSE(In::overlap_at(tiny, region, {4, 4}));
  }
}

TYPED_TEST(ComponentTestIn, looks_at_every_pair_of_components) {
  using In = ComponentTestIn<TypeParam>;
  const Region p{{{box(0, 0, 1, 1), {}}, {box(10, 0, 11, 1), {}}, {box(20, 0, 29, 9), {}}}};
  const Region q{{{box(0, 0, 1, 1), {}}, {box(0, 40, 1, 41), {}}}};
  EXPECT_TRUE(In::overlap_at(p, q, {25, 5})) << "the last and the first";
  EXPECT_TRUE(In::overlap_at(p, q, {25, 45})) << "the last and the last";
  EXPECT_FALSE(In::overlap_at(p, q, {25, 25}));
  EXPECT_TRUE(In::overlap_at(q, p, {25, 45}));
  EXPECT_FALSE(In::overlap_at(q, p, {15, 45}));
}

TYPED_TEST(ComponentTestIn, counts_vertices_level_with_each_other_once) {
  using In = ComponentTestIn<TypeParam>;
  // To the right of (0, 4): a vertex that the ray passes, one that it touches, and an edge along it.
  const Region p = polygon({{-9, -9},
                            {30, -9},
                            {20, 4},
                            {30, 9},
                            {18, 9},
                            {16, 4},
                            {14, 9},
                            {10, 9},
                            {8, 4},
                            {6, 4},
                            {5, 9},
                            {-9, 9}});
  const Region q = polygon({{0, 0}, {1, 0}, {0, 1}});
  for (const Vector& along : {Vector{1, 0}, Vector{-1, 0}, Vector{0, 1}, Vector{0, -1},
                              Vector{1, 1}, Vector{-2, 1}, Vector{1, -1}, Vector{-1, -1}}) {
    const Segment inside{{0, 4}, Point{0, 4} + along}, outside{{-12, 4}, Point{-12, 4} + along};
    EXPECT_TRUE(In::overlap_at(p, q, inside, 0, 1));
    EXPECT_TRUE(In::overlap_at(q, p, inside, 0, 1));
    EXPECT_FALSE(In::overlap_at(p, q, outside, 0, 1));
    EXPECT_FALSE(In::overlap_at(q, p, outside, 0, 1));
  }
}

TYPED_TEST(ComponentTestIn, comes_apart_to_the_right_where_a_vertex_slides_along_an_edge) {
  using In = ComponentTestIn<TypeParam>;
  const Region square = polygon(box(0, 0, 10, 10));
  // -Q is to the left of x, and to the right of it.
  const Region pointing_right = polygon({{0, 0}, {2, -1}, {2, 1}});
  const Region pointing_left = polygon({{0, 0}, {-2, 1}, {-2, -1}});
  const Point on_the_right_side{10, 5}, on_the_left_side{0, 5};
  for (int times = 0; times < 4; ++times) {
    const auto overlap = [&](const Region& q, const Point& x, const Vector& along) {
      const LinearMap turned = quarter_turns(times);
      const Region p = image(turned, square), of_q = image(turned, q);
      const Segment slid{turned(x), turned(x + along)};
      const bool result = In::overlap_at(p, of_q, slid, 0, 1);
      EXPECT_EQ(In::overlap_at(of_q, p, slid, 0, 1), result) << times;
      return result;
    };
    EXPECT_TRUE(overlap(pointing_right, on_the_right_side, {0, -1})) << times;
    EXPECT_FALSE(overlap(pointing_left, on_the_right_side, {0, 1})) << times;
    EXPECT_TRUE(overlap(pointing_left, on_the_left_side, {0, 1})) << times;
    EXPECT_FALSE(overlap(pointing_right, on_the_left_side, {0, -1})) << times;
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
    Rational t(numerator, denominator);
    t.canonicalize();
    // Infinitesimals that small integers can't tell from real ones.
    const Point exact = segment.source + t * d;
    const Rational little(1, 1000000);
    const Point shifted = exact + little * d + little * little * Vector{d.y, -d.x};
    const Region minus_q = translated(reflected(q), shifted);
    if (edges_meet(large, minus_q)) continue;
    const bool expected = interiors_meet(large, minus_q);
    ++(expected ? overlapping : apart);
    touching += edges_meet(large, translated(reflected(q), exact)) ? 1 : 0;
    const auto expect_told = [&]<typename Numbers>(ComponentTestIn<Numbers>* /*which*/) {
      using In = ComponentTestIn<Numbers>;
      EXPECT_EQ(In::overlap_at(large, q, segment, numerator, denominator), expected) << k;
      EXPECT_EQ(In::overlap_at(q, large, segment, numerator, denominator), expected) << k;
    };
    expect_told(static_cast<ComponentTestIn<SmallNumbers>*>(nullptr));
    expect_told(static_cast<ComponentTestIn<WideNumbers>*>(nullptr));
    expect_told(static_cast<ComponentTestIn<AnyNumbers>*>(nullptr));
  }
  EXPECT_GT(overlapping, 20u);
  EXPECT_GT(apart, 200u);
  EXPECT_GT(touching, 20u);
}

template <typename Numbers>
void expect_that_of_gmp_at_the_limit() {
  const Rational m = power_of_two(Numbers::bits) - 1;
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
            const auto overlap_in = [&]<typename In>(ComponentTestIn<In>* /*which*/) {
              const Scaling scaling = scaling_of(p, turned_q);
              const auto both = ComponentTestIn<In>::summands(p, turned_q, scaling);
              const IntegerSegment<In> exact = integer_segment<In>(segment);
              return ComponentTest<In>(both).overlap_at({exact, near(exact, scaling)},
                                                        {value<In>(n), value<In>(d)});
            };
            const bool expected = overlap_in(static_cast<ComponentTestIn<AnyNumbers>*>(nullptr));
            EXPECT_EQ(overlap_in(static_cast<ComponentTestIn<Numbers>*>(nullptr)), expected);
            overlapping += expected ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(overlapping, 10u);
}

TEST(ComponentTest, at_the_limit_of_64_bits_is_that_of_gmp) {
  expect_that_of_gmp_at_the_limit<SmallNumbers>();
}

TEST(ComponentTest, at_the_limit_of_256_bits_is_that_of_gmp) {
  expect_that_of_gmp_at_the_limit<WideNumbers>();
}

}  // namespace
}  // namespace oplus::slide
