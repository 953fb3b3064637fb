// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

TEST(GeoJson, numbers_are_exact) {
  const ReadRegion read = region_from(
      R"({"type": "Polygon", "coordinates": [[[0.1, -2.5e-3],
          [123456789012345678901234567890.1, 18446744073709551615],
          ["1/3", -9223372036854775809], [0.1, "-1/400"]]]})");
  EXPECT_EQ(
      read.region.components.at(0).outer,
      Chain({{Rational(1, 10), Rational(-1, 400)},
             {Rational(1, 3), Rational("-9223372036854775809")},
             {Rational("1234567890123456789012345678901/10"), Rational("18446744073709551615")}}));
  EXPECT_EQ(read.notes.size(), 1U);
}

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
