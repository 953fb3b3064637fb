// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cycles/convolution_cycles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/families/family.hpp"
#include "reference/families/polygons.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});

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
