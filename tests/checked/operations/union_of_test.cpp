// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/union_of.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(UnionOf, of_each_valid_region_alone_is_that_region) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    EXPECT_EQ(union_of(shape.region), canonical_sum(shape.region));
    EXPECT_EQ(union_of(together({shape.region, shape.region})), canonical_sum(shape.region));
  }
}

TEST(UnionOf, takes_the_plane_without_holes) {
  Region outside;
  outside.components.push_back({{}, {backwards(box(0, 0, 4, 4))}});
  const PlanarSet all = union_of(together({outside, polygon(box(1, 1, 2, 2))}), {{{-1, 3}, {3, 3}}},
                                 {{9, 9}, {3, 1}});
  EXPECT_TRUE(all.is_unbounded);
  EXPECT_EQ(all.outer, std::vector<Chain>{box(1, 1, 2, 2)});
  EXPECT_EQ(all.holes.size(), 1U);
  EXPECT_EQ(all.dangling_edges, (std::vector<Segment>{{{0, 3}, {3, 3}}}));
  EXPECT_EQ(all.isolated_vertices, (std::vector<Point>{{3, 1}}));
}

}  // namespace
}  // namespace oplus
