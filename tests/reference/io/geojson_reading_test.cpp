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

TEST(GeoJson, members_come_in_any_order_and_strings_may_have_escapes) {
  const Region expected =
      region_from(R"({"type": "Polygon", "coordinates": [[[0, 0], [3, 0], [0, "1/3"], [0, 0]]]})")
          .region;
  for (const std::string text :
       {R"({"coordinates": [[[0, 0], [3, 0], [0, "1\/3"], [0, 0]]], "type": "Polygon"})",
        R"({"x": [{"type": [1, {}, ""]}, null, "]}"], "coordinates": [[[0,0],[3,0],[0,
            "\u0031/3"],[0,0]]], "t\u0079pe": "Pol\u0079gon", "y": {"a": {"a": [true, -1.5e3]}}})"})
    EXPECT_EQ(region_from(text).region, expected) << text;
  // Wrong syntax behind a wrong value is what is refused, wherever the type stands.
  EXPECT_EQ(refusal([] { region_from(R"({"coordinates": [[[0, true]]], "type": "Polygon")"); }),
            "file:1:49: the end of the input in JSON; expected ',' or '}'");
  EXPECT_EQ(
      refusal([] { region_from("{\"coordinates\": [[[0,\n true]]], \"type\": \"Polygon\"}"); }),
      "file:2:2: y of vertex 1 of outer chain of component 1 is a boolean; expected a number or "
      "a string \"p/q\"");
}

TEST(GeoJson, of_several_lines_is_one_region) {
  const std::string triangle = R"({"type": "Polygon", "coordinates": [[[0,0],[1,0],[0,1],[0,0]]]})";
  const std::string other = R"({"type": "Feature", "geometry":
      {"type": "Polygon", "coordinates": [[[5,5],[6,5],[5,6],[5,5]]]}})";
  EXPECT_EQ(region_from("\n" + triangle + " \r\n\n " + other + "\n").region,
            region_from("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5)))").region);
  const auto refused = [](const std::string& text, const std::string& message) {
    EXPECT_EQ(refusal([&] { region_from(text); }), message);
  };
  refused(triangle + " " + triangle, "file:1:65: '{' in JSON; expected the end of the input");
  refused(triangle + "\n[]", "file:2:1: '[' in JSON; expected the end of the input");
  refused("[[0,0],[1,0],[0,1]]\n" + triangle,
          "file:2:1: '{' in JSON; expected the end of the input");
  refused(triangle + "\n" + other + "\n {\"type\": 3}",
          "file:4:11: the type of a geometry is a number; expected a string");
  refused(triangle + "\n" + other + "\n\n{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,x]]]}",
          "file:5:47: 'x' in JSON; expected a value");
  refused(triangle + "\n" + triangle,
          "file:2:38: outer chain of component 1 and outer chain of component 2 overlap at (0, 0): "
          "edge 1 from (0, 0) to (1, 0) and edge 1 from (0, 0) to (1, 0); expected chains that at "
          "most touch in points");
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
