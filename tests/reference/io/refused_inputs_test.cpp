// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <nlohmann/json.hpp>

#include "properties/runner/source_tree.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

/// tests/corpus/refused_inputs.json: texts that are not regions or sums, and the message for each.
TEST(RefusedInputs, are_refused_in_the_line_that_is_recorded) {
  std::ifstream file(source_root() / "tests/corpus/refused_inputs.json");
  const nlohmann::json all = nlohmann::json::parse(file);
  EXPECT_GE(all.size(), 123U);
  for (const nlohmann::json& input : all) {
    SCOPED_TRACE(input.at("name").get<std::string>());
    const auto text = input.at("text").get<std::string>();
    for (const std::string as : input.at("as")) {
      const auto read = [&] { as == "sum" ? (void)sum_from(text) : (void)region_from(text); };
      EXPECT_EQ(refusal(read), input.at("refusal").get<std::string>()) << "as a " << as;
    }
  }
}

// What JSON cannot hold, or would be unreadable there.

TEST(RefusedInputs, may_be_no_text) {
  const std::string expected =
      "' is not text; expected a region in .dat, WKT, WKB or GeoJSON, an array, or the data of an SVG path";
  for (const auto& [text, place] :
       {std::pair{std::string("3 0 0\n1 \0 0 1", 13), "file:2:3: the byte '\\x00"},
        {std::string("\x1f\x8b\x08"), "file:1:1: the byte '\\x1f"}}) {
    EXPECT_EQ(refusal([&] { region_from(text); }), place + expected);
    EXPECT_EQ(refusal([&] { sum_from(text); }), place + expected);
  }
}

TEST(RefusedInputs, are_quoted_up_to_a_length) {
  EXPECT_EQ(refusal([] { region_from(std::string(50, '?')); }),
            "file:1:1: '" + std::string(40, '?') +
                "...' where the number of vertices of outer chain of component 1 should be; "
                "expected an integer without a sign");
  EXPECT_EQ(refusal([] { region_from("{\"a\": " + std::string(5000, 'x') + "}"); }),
            "file:1:7: '" + std::string(40, 'x') + "...' in JSON; expected a value");
}

}  // namespace
}  // namespace oplus
