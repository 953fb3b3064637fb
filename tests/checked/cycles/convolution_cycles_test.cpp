// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cycles/convolution_cycles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reference/families/family.hpp"
#include "reference/families/polygons.hpp"
#include "tests/reference/definitions/pairs_of_shapes.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

const Region l_shape = polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});
const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});

std::multiset<std::size_t> sizes(const ConvolutionCycles& traced) {
  std::multiset<std::size_t> result;
  for (const ConvolutionCycle& cycle : traced.cycles) result.insert(cycle.size());
  return result;
}

using Sizes = std::multiset<std::size_t>;

void expect_equal(std::vector<ConvolutionSegment> traced, std::vector<ConvolutionSegment> defined) {
  const auto by_origin = [](const auto& a, const auto& b) { return a.origin < b.origin; };
  std::sort(traced.begin(), traced.end(), by_origin);
  std::sort(defined.begin(), defined.end(), by_origin);
  ASSERT_EQ(traced.size(), defined.size());
  for (std::size_t k = 0; k < traced.size(); ++k) {
    ASSERT_EQ(traced[k].origin, defined[k].origin);
    ASSERT_EQ(traced[k].segment, defined[k].segment);
    ASSERT_EQ(traced[k].vertex_is_reflex, defined[k].vertex_is_reflex);
  }
}

void expect_as_defined(const Region& p, const Region& q) {
  const ConvolutionCycles cycles = convolution_cycles(p, q);
  expect_equal(full_convolution(cycles), convolution(p, q));
  expect_equal(reduced_convolution(cycles), reduced_convolution(p, q));
  expect_equal(traced_convolution(p, q), convolution(p, q));
  expect_equal(traced_reduced_convolution(p, q), reduced_convolution(p, q));
  const ConvolutionSize size = convolution_size(p, q);
  EXPECT_EQ(size.segments, convolution(p, q).size());
  EXPECT_EQ(size.reduced_segments, reduced_convolution(p, q).size());
  EXPECT_EQ(size.cycles, cycles.cycles.size());
  EXPECT_EQ(size.steps, cycles.steps);
}

TEST(ConvolutionCycles, are_the_convolution_for_shapes_of_every_kind) {
  for_each_pair_of_shapes(expect_as_defined);
}

TEST(ConvolutionCycles, are_the_convolution_beyond_doubles) {
  const Rational huge("1" + std::string(400, '0'));
  const Rational third(1, 3);
  const Region p = polygon({{0, 0}, {huge, third}, {huge + 1, huge}, {third, huge + third}});
  const Region q = polygon({{0, 0}, {3 * huge, 1}, {1 / huge, 1 / huge}, {-1, 3 * huge}});
  for (const Shape& other :
       {Shape{"huge + huge", q}, {"equal directions", p}, {"opposite directions", reflected(p)}}) {
    SCOPED_TRACE(other.name);
    expect_as_defined(p, other.region);
  }
}

TEST(ConvolutionCycles, two_convex_polygons_have_one_cycle_of_all_edges) {
  const Region square = polygon(box(0, 0, 2, 2));
  const Region pentagon = polygon({{0, 0}, {4, -1}, {6, 2}, {3, 5}, {-1, 3}});
  EXPECT_EQ(sizes(convolution_cycles(square, pentagon)), Sizes{9});
  EXPECT_EQ(sizes(convolution_cycles(square, square)), Sizes{8});
}

TEST(ConvolutionCycles, go_twice_round_what_does_not_pass_a_reflex_vertex) {
  const Region square = polygon(box(0, 0, 1, 1));
  EXPECT_EQ(sizes(convolution_cycles(square, l_shape)), Sizes{4 + 4 + 6});
  EXPECT_EQ(sizes(convolution_cycles(l_shape, square)), Sizes{4 + 4 + 6});
}

TEST(ConvolutionCycles, of_two_shapes_with_parallel_edges_everywhere) {
  EXPECT_EQ(sizes(convolution_cycles(l_shape, l_shape)), (Sizes{12, 12}));
}

TEST(ConvolutionCycles, vertices_inside_straight_lines_count_as_edges_only) {
  const Region square = polygon({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}});
  EXPECT_EQ(sizes(convolution_cycles(square, triangle)), Sizes{6 + 3});
  for (const ConvolutionSegment& s : full_convolution(convolution_cycles(square, triangle)))
    EXPECT_FALSE(s.origin.edge_of == Summand::Q && s.origin.vertex.vertex == 1)
        << "the tangent set of a vertex inside a straight line is empty";
}

TEST(ConvolutionCycles, holes_have_their_own) {
  const Region frame{{{box(0, 0, 9, 9), {backwards(box(3, 3, 6, 6))}}}};
  const ConvolutionCycles traced = convolution_cycles(frame, triangle);
  std::size_t of_outer = 0, of_hole = 0;
  for (const ConvolutionCycle& cycle : traced.cycles) {
    for (const ConvolutionSegment& s : cycle) {
      const bool of_p = s.origin.edge_of == Summand::P;
      ((of_p ? s.origin.edge : s.origin.vertex).chain == 0 ? of_outer : of_hole) += 1;
    }
  }
  EXPECT_EQ(of_outer, 4U + 3);
  EXPECT_EQ(of_hole, 4U + 3 * (4 - 1)) << "each direction is in all but one of four tangent sets";
}

TEST(ConvolutionCycles, corollary_4_1_9_as_printed_is_false) {
  // Row corollary_4_1_9 of the corpus. No point is passed twice, so there is no other cycle either.
  const Region arrow_head = polygon({{0, 0}, {2, 1}, {0, 2}, {1, 1}});
  const ConvolutionCycles traced = convolution_cycles(triangle, arrow_head);
  ASSERT_EQ(sizes(traced), Sizes{3 + 3 + 4});
  std::set<Point> points;
  for (const ConvolutionSegment& s : traced.cycles[0]) points.insert(s.segment.source);
  EXPECT_EQ(points.size(), 10U);
}

TEST(ConvolutionCycles, steps_grow_with_the_convolution) {
  for (const char* name : {"convex", "star", "simple", "comb", "fork"}) {
    for (const std::size_t n : {4U, 8U, 16U, 32U}) {
      const Summands pair = generate(*find_family(name), n, n);
      const ConvolutionCycles traced = convolution_cycles(pair.p, pair.q);
      const std::size_t k = full_convolution(traced).size();
      EXPECT_EQ(traced.steps + traced.cycles.size(),
                vertex_count(pair.p) + vertex_count(pair.q) - 1 + k)
          << name << ' ' << n;
      EXPECT_LT(traced.steps, 2 * k) << name << ' ' << n;
    }
  }
}

TEST(ConvolutionCycles, steps_of_many_chains_are_less_than_twice_the_segments) {
  for (const char* name : {"holes", "components"}) {
    for (const std::size_t n : {3U, 6U, 12U}) {
      const Summands pair = generate(*find_family(name), n, n);
      const ConvolutionCycles traced = convolution_cycles(pair.p, pair.q);
      EXPECT_LT(traced.steps, 2 * full_convolution(traced).size()) << name << ' ' << n;
    }
  }
}

TEST(ConvolutionCycles, of_convex_polygons_do_not_look_at_the_whole_grid) {
  Random random(1);
  const Region p = convex_polygon(random, 500);
  const Region q = convex_polygon(random, 500);
  EXPECT_LT(convolution_cycles(p, q).steps, 2000U) << "of 250000 states";
}

TEST(ConvolutionCycles, come_in_the_order_of_the_starts_and_so_do_all_lists) {
  const Summands pair = generate(*find_family("star"), 12, 5);
  const std::vector<ConvolutionSegment> full = full_convolution(convolution_cycles(pair.p, pair.q));
  const std::vector<ConvolutionSegment> again = traced_convolution(pair.p, pair.q);
  const std::vector<TracedOrigin> origins = traced_origins(pair.p, pair.q);
  ASSERT_EQ(full.size(), again.size());
  ASSERT_EQ(full.size(), origins.size());
  for (std::size_t k = 0; k < full.size(); ++k) {
    EXPECT_EQ(full[k].origin, again[k].origin);
    EXPECT_EQ(full[k].origin, origins[k].origin);
    EXPECT_EQ(full[k].vertex_is_reflex, origins[k].vertex_is_reflex);
  }
}

TEST(ConvolutionCycles, of_the_empty_region_are_none) {
  const ConvolutionCycles none = convolution_cycles(Region{}, triangle);
  EXPECT_TRUE(none.cycles.empty());
  EXPECT_EQ(none.steps, 0U);
  EXPECT_TRUE(traced_reduced_convolution(triangle, Region{}).empty());
  EXPECT_EQ(convolution_size(Region{}, triangle).segments, 0U);
}

}  // namespace
}  // namespace oplus
