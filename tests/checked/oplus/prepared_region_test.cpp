// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion frame =
    polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
const ValidRegion plug = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
const ValidRegion triangle = polygon({{0, 0}, {"1/3", 0}, {0, "0.7"}});

TEST(PreparedRegion, has_the_sums_of_its_region) {
  const PreparedRegion prepared(frame);
  EXPECT_EQ(prepared.region(), frame);
  for (const Boundary boundary : {Boundary::closed, Boundary::open})
    for (const ValidRegion& other : {plug, triangle, frame, ValidRegion()}) {
      const SumOptions options = {.boundary = boundary, .with_origins = true};
      const ValidSet expected = minkowski_sum(frame, other, options);
      // Either of the two may be a region as it is.
      for (const ValidSet& sum : {minkowski_sum(prepared, PreparedRegion(other), options),
                                  minkowski_sum(prepared, other, options)}) {
        EXPECT_EQ(sum, expected);
        EXPECT_EQ(sum.boundary(), boundary);
        EXPECT_EQ(sum.origins(), expected.origins());
      }
      EXPECT_EQ(minkowski_sum(other, prepared, options), minkowski_sum(other, frame, options));
    }
  EXPECT_EQ(minkowski_sum(prepared, -plug, {.boundary = Boundary::open}).isolated_vertices(),
            std::vector({Point{1, 1}}));
}

TEST(PreparedRegion, may_be_unbounded) {
  const PreparedRegion outside(complement(frame));
  EXPECT_EQ(minkowski_sum(outside, plug), minkowski_sum(outside.region(), plug));
  EXPECT_EQ(minkowski_sum(plug, outside), minkowski_sum(plug, outside.region()));
}

}  // namespace
}  // namespace oplus
