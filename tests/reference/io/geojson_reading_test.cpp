// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(GeoJson, numbers_beyond_a_double_are_exact) {
  const Region region = region_from(R"({"type": "Polygon",
      "coordinates": [[[0, 0], [1e4000, 0], [1e-4000, 1], [0, 0]]]})")
                            .region;
  EXPECT_EQ(region.components.at(0).outer.at(1).x * region.components.at(0).outer.at(2).x, 1);
  const std::string long_number(5000, '7');
  EXPECT_EQ(region_from("{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [" + long_number +
                        ", 0], [0, 1], [0, 0]]]}")
                .region.components.at(0)
                .outer.at(1)
                .x,
            Rational(long_number));
}

std::string nested(std::size_t depth, const std::string& open) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += open;
  return text;
}

TEST(GeoJson, deep_nesting_is_refused) {
  EXPECT_EQ(refusal([] { region_from("{\"a\":" + nested(1000000, "[")); }),
            "file:1:69: JSON nested deeper than 64 levels; expected a geometry");
  EXPECT_EQ(refusal([] { region_from(nested(1000000, "{\"a\":")); }),
            "file:1:321: JSON nested deeper than 64 levels; expected a geometry");
}

}  // namespace
}  // namespace oplus
