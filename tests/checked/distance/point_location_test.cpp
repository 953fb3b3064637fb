// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/distance/point_location.hpp"

#include <gtest/gtest.h>

#include <array>

#include "checked/operations/complement.hpp"
#include "checked/slide/slide.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/families/family.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// Vertices and midpoints of its edges, points beside these, above and below them, and far away.
std::vector<Point> places_around(const PlanarSet& set) {
  std::vector<Point> at = set.isolated_vertices;
  for (const Segment& e : edges(set)) {
    at.push_back(e.source);
    at.push_back(midpoint(e.source, e.target));
  }
  std::vector<Point> all = {{-1000, 0}, {1000, 0}, {0, 1000}, {Rational(1, 3), 0}};
  const Rational little(1, 7);
  for (const Point& p : at)
    for (const Vector& by :
         {Vector{0, 0}, {0, little}, {0, -little}, {little, 0}, {-little, 0}, {0, 5}})
      all.push_back(p + by);
  return all;
}

void expect_as_defined(const PlanarSet& set, std::array<std::size_t, 3>& counts) {
  const PointLocation location(set);
  for (const Point& x : places_around(set)) {
    const Location right = locate(x, set);
    EXPECT_EQ(location.locate(x), right) << to_string(x);
    ++counts[static_cast<std::size_t>(right)];
  }
}

TEST(PointLocation, is_as_defined_of_open_sums) {
  std::array<std::size_t, 3> counts{};
  std::size_t edges = 0, vertices = 0;
  for (const std::string name :
       {"tight", "grid", "holes", "components", "comb", "fractions", "touching"}) {
    const Family& family = *find_family(name);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const auto [p, q] = generate(family, std::max<std::size_t>(4, family.smallest), seed);
      const PlanarSet sum = slide_sum(p, q, Boundary::open).sum;
      edges += sum.dangling_edges.size();
      vertices += sum.isolated_vertices.size();
      expect_as_defined(sum, counts);
    }
  }
  for (const std::size_t count : counts) EXPECT_GE(count, 500U);
  EXPECT_GE(edges, 3U);
  EXPECT_GE(vertices, 3U);
}

TEST(PointLocation, of_sets_with_vertical_edges_without_edges_and_unbounded_ones) {
  std::array<std::size_t, 3> counts{};
  expect_as_defined({}, counts);
  PlanarSet plane;
  plane.is_unbounded = true;
  expect_as_defined(plane, counts);
  plane.isolated_vertices = {{0, 0}, {0, 1}};
  plane.dangling_edges = {{{0, 2}, {0, 5}}, {{1, 1}, {3, 0}}};
  expect_as_defined(plane, counts);
  const PlanarSet frame = canonical_sum(generate(*find_family("holes"), 4, 2).p);
  expect_as_defined(frame, counts);
  expect_as_defined(canonical_sum(complement(generate(*find_family("grid"), 5, 3).p)), counts);
}

}  // namespace
}  // namespace oplus
