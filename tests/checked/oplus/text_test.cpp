// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

const ValidRegion triangle = polygon({{0, 0}, {1, 0}, {0.5, "1/3"}});
const ValidRegion frame =
    polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});

ValidSet open_sum() {
  return minkowski_sum(frame, polygon({{0, 0}, {-2, 0}, {-2, -1}, {0, -1}}),
                       {.boundary = Boundary::open});
}

TEST(Text, of_what_was_rounded_is_valid) {
  const ValidSet sum = minkowski_sum(triangle, triangle);
  const Rounded nearest = rounded(sum, "0.3");
  EXPECT_EQ(nearest.bound, Number("0.15").value());
  EXPECT_FALSE(nearest.is_exact);
  EXPECT_EQ(nearest.changes, TopologyChanges{});
  EXPECT_EQ(rounded(triangle, 1, Side::contained).changes.vanished_components, 1U);
  EXPECT_EQ(read_wkt(to_wkt(rounded(sum, 0.25, Side::contain).sum)),
            rounded(sum, 0.25, Side::contain).sum.region());
  EXPECT_TRUE(rounded(open_sum(), 1).is_exact);
  EXPECT_EQ(rounded(open_sum(), 1).sum, open_sum());
}

TEST(Text, in_wkb_is_that_of_doubles) {
  EXPECT_TRUE(to_wkb(open_sum()).starts_with("0107000000"));
  EXPECT_THROW(to_wkb(triangle), InvalidInput);
}

TEST(Text, refuses_other_numbers_of_digits) {
  for (const int digits : {-1, 4097}) {
    EXPECT_THROW(to_wkt(triangle, digits), std::invalid_argument);
    EXPECT_THROW(to_geojson(triangle, digits), std::invalid_argument);
    EXPECT_THROW(to_wkt(ValidSet(), digits), std::invalid_argument);
    EXPECT_THROW(to_geojson(ValidSet(), digits), std::invalid_argument);
  }
  EXPECT_NO_THROW(to_wkt(triangle, 4096));
}

}  // namespace
}  // namespace oplus
