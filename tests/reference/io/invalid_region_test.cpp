// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/invalid_region.hpp"

#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(ValidRegion, may_have_a_component_in_a_hole) {
  const ReadRegion read = region_from(
      "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 8, 8 8, 8 1, 1 1)),"
      " ((2 2, 3 2, 2 3, 2 2)))");
  EXPECT_EQ(read.region.components.size(), 2U);
}

TEST(ValidRegion, may_have_chains_that_touch) {
  const ReadRegion read = region_from(
      "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (0 0, 1 2, 2 1, 0 0)),"
      " ((4 4, 5 4, 5 5, 4 4)), ((4 2, 6 1, 6 3, 4 2)))");
  EXPECT_EQ(read.region.components.size(), 3U);
}

}  // namespace
}  // namespace oplus
