// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/complement.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/region.hpp"
#include "reference/families/family.hpp"

namespace oplus {
namespace {

TEST(Complement, of_a_polygon_is_the_plane_with_a_hole) {
  const Chain square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Region outside = complement(polygon(square));
  ASSERT_EQ(outside.components.size(), 1U);
  EXPECT_TRUE(outside.components[0].outer.empty());
  EXPECT_EQ(outside.components[0].holes, (std::vector<Chain>{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}));
}

TEST(Complement, of_the_empty_set_is_the_plane) {
  EXPECT_EQ(complement(Region{}), Region{{Component{}}});
  EXPECT_EQ(complement(Region{{Component{}}}), Region{});
}

/// Squares that touch in a corner are one chain around the outer face, and two holes of the complement.
TEST(Complement, has_chains_around_its_own_faces) {
  const Region squares = {{Component{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}},
                           Component{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {}}}};
  const MinkowskiSum set = canonical_sum(squares);
  EXPECT_EQ(set.outer.size(), 1U);
  EXPECT_EQ(complement(set).holes.size(), 2U);
  EXPECT_EQ(complement(complement(set)), set);
}

TEST(Complement, keeps_edges_and_points) {
  const MinkowskiSum set = {{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, {}, {{{1, 1}, {2, 1}}}, {{5, 5}}};
  const MinkowskiSum rest = complement(set);
  EXPECT_EQ(rest.dangling_edges, set.dangling_edges);
  EXPECT_EQ(rest.isolated_vertices, set.isolated_vertices);
  EXPECT_EQ(complement(rest), set);
}

TEST(Complement, twice_is_the_region_and_each_point_is_in_one_of_the_two) {
  for (const char* name : {"grid", "holes", "islands", "components"}) {
    const Family& family = *find_family(name);
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const Region region = generate(family, family.typical, seed).p;
      const Region outside = complement(region);
      EXPECT_EQ(canonical_sum(complement(outside)), canonical_sum(region)) << name << seed;
      for (int x = -2; x <= 6; ++x) {
        for (int y = -2; y <= 6; ++y) {
          const Point p{Rational(2 * x + 1, 2), Rational(3 * y + 1, 3)};
          const Location here = locate(p, region), there = locate(p, outside);
          EXPECT_EQ(here == Location::boundary, there == Location::boundary);
          EXPECT_EQ(here == Location::inside, there == Location::outside);
        }
      }
    }
  }
}

}  // namespace
}  // namespace oplus
