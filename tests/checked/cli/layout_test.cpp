// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class LayoutCommand : public Shell {
 protected:
  LayoutCommand() {
    put("parts.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\nPOLYGON ((2 0, 4 0, 4 2, 2 2, 2 0))\n");
    put("wrong.wkt",
        "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\nPOLYGON ((1 0, 3 1/3, 3 2, 1 2, 1 0))\n");
    put("bin.wkt", "POLYGON ((0 0, 4 0, 4 2, 0 2, 0 0))");
    put("small.wkt", "POLYGON ((0 0, 3 0, 3 2, 0 2, 0 0))");
    put("defect.wkt",
        "POLYGON ((3.5 1, 9 1, 9 3, 3.5 3, 3.5 1))\nPOLYGON ((4 0, 5 0, 5 1.5, 4 1.5, 4 0))");
  }
};

TEST_F(LayoutCommand, says_right_or_wrong_by_its_exit_code) {
  const std::string container = "2 parts, used area 8, 100 % of the container\n";
  expect_output("oplus layout parts.wkt --container bin.wkt", "right\n" + container);
  for (const std::string options : {"--container small.wkt", "--spacing 1e-12",
                                    "--defects defect.wkt", "--container bin.wkt --margin 1e-12"}) {
    const Ran ran = run("oplus layout parts.wkt " + options, 1);
    EXPECT_EQ(ran.out.substr(0, 7), "wrong: ") << options;
  }
  run("oplus layout wrong.wkt", 1);
  run("oplus layout wrong.wkt --tolerance 0.999", 1);
  const Ran forgiven = run("oplus layout wrong.wkt --tolerance 1", 0);
  EXPECT_TRUE(has(forgiven.out, "\n1 overlap is forgiven\n"));
}

TEST_F(LayoutCommand, writes_parts_where_they_lie_and_the_container) {
  put("turned.json", R"({"container": [[0, 0], [4, 0], [4, 4], [0, 4]],
    "parts": {"a": [[0, 0], [2, 0], [2, 1], [0, 1]]},
    "placements": [{"part": "a", "at": [3, 1], "rotation": 90}, {"part": "a", "at": ["1/3", 3]}]})");
  expect_output(
      "oplus layout turned.json --format wkt",
      "POLYGON ((3 1, 3 3, 2 3, 2 1, 3 1))\nPOLYGON ((1/3 3, 7/3 3, 7/3 4, 1/3 4, 1/3 3))\n");
  expect_output("oplus layout turned.json --format container",
                "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n");
  expect_output("oplus layout parts.wkt --format container", "POLYGON EMPTY\n");
}

TEST_F(LayoutCommand, answers_in_json_and_in_pictures) {
  const auto answer = nlohmann::json::parse(run("oplus layout wrong.wkt --format json").out);
  EXPECT_EQ(answer["answer"], "wrong");
  const auto& sheet = answer["sheets"][0];
  EXPECT_EQ(sheet["lines"], nlohmann::json({1, 2}));
  const auto& fault = sheet["faults"][0];
  EXPECT_EQ(fault["kind"], "overlap");
  EXPECT_EQ(fault["parts"], nlohmann::json({1, 2}));
  EXPECT_EQ(fault["area"], "23/12");
  EXPECT_EQ(fault["squared_depth"], "1");
  EXPECT_EQ(fault["move"], nlohmann::json({"1", "0"}));
  const Ran drawn = run("oplus layout wrong.wkt --format svg -o wrong.svg", 1);
  EXPECT_EQ(drawn.out, "");
  EXPECT_TRUE(has(content("wrong.svg"), "class=\"wrong-part\""));
  run("oplus layout parts.wkt --format svg -o right.svg");
  EXPECT_FALSE(has(content("right.svg"), "class=\"wrong-part\""));
}

TEST_F(LayoutCommand, refuses_in_one_line_what_it_cannot_check) {
  put("missing.json", "{\"parts\": {}, \"placements\": [\n{\"part\": \"a\"}]}");
  put("beside.json", "{\"parts\": {\"a\": {\"file\": \"none.wkt\"}}, \"placements\": []}");
  const std::pair<std::string, std::string> cases[] = {
      {"parts.wkt --tolerance -1", "--tolerance takes a distance, not the negative number '-1'"},
      {"parts.wkt --spacing wide", "--spacing: 'wide' is not a number"},
      {"parts.wkt --margin 1/0", "--margin"},
      {"parts.wkt --angle-error 0", "--angle-error"},
      {"parts.wkt --format png", "--format"},
      {"parts.wkt --container none.wkt", "none.wkt"},
      {"missing.json", "missing.json:2:10: placement 1: there is no part 'a'; expected"},
      {"beside.json", "part 'a': cannot be opened"},
      {"none.json", "none.json: cannot be opened"}};
  for (const auto& [arguments, message] : cases)
    expect_refusal("oplus layout " + arguments, message);
}

}  // namespace
}  // namespace oplus
