// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class RepairCommand : public Shell {
 protected:
  RepairCommand() {
    put("drawn.wkt", "POLYGON ((0 0, 4 0, 4 0,\n 4 4, 6 6, 4 4, 0 4))");
    put("tie.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))");
    put("square.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  }
};

const std::string square = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n";

TEST_F(RepairCommand, says_what_it_did_and_where) {
  const Ran ran = run("oplus repair drawn.wkt", 0);
  EXPECT_EQ(ran.out, square);
  EXPECT_EQ(
      ran.err,
      "oplus: drawn.wkt:2:17: outer chain of component 1 was not closed; an edge goes from (0, "
      "4) to (0, 0)\n"
      "oplus: drawn.wkt:1:21: vertex 3 of outer chain of component 1 is equal to vertex 2, (4, "
      "0); left out\n"
      "oplus: drawn.wkt:2:7: vertex 5 of outer chain of component 1, (6, 6), is the tip of a "
      "spike; left out\n"
      "oplus: drawn.wkt:2:12: vertex 6 of outer chain of component 1 is equal to vertex 4, (4, "
      "4); left out\n"
      "oplus: drawn.wkt: 4 repairs\n");
  expect_output("oplus --quiet repair drawn.wkt", square);
}

TEST_F(RepairCommand, of_a_valid_region_does_nothing_and_says_so) {
  const Ran ran = run("oplus repair square.wkt -o same.wkt", 0);
  EXPECT_EQ(ran.err, "oplus: square.wkt: nothing to repair\n");
  EXPECT_EQ(content("same.wkt"), square);
}

TEST_F(RepairCommand, answers_in_json) {
  const Ran ran = run("oplus --quiet repair drawn.wkt -o whole.dat --json", 0);
  EXPECT_EQ(ran.err, "");
  const nlohmann::json answer = nlohmann::json::parse(ran.out);
  EXPECT_EQ(answer.at("count"), 4);
  ASSERT_EQ(answer.at("mends").size(), 4U);
  const nlohmann::json& spike = answer["mends"][2];
  EXPECT_EQ(spike.at("kind"), "spike");
  EXPECT_EQ(spike.at("line"), 2);
  EXPECT_EQ(spike.at("column"), 7);
  EXPECT_EQ(spike.at("what"),
            "vertex 5 of outer chain of component 1, (6, 6), is the tip of a spike; left out");
  expect_output("oplus --quiet repair whole.dat -o again.dat --json",
                "{\n  \"count\": 0,\n  \"mends\": []\n}\n");
}

TEST_F(RepairCommand, refuses_what_it_cannot_do) {
  expect_refusal("oplus repair", "R");
  expect_refusal("oplus repair missing.wkt", "missing.wkt");
  expect_refusal("oplus repair tie.wkt -o out.wkt",
                 "tie.wkt:1:21: two edges of outer chain of component 1 cross at (1, 1)");
  expect_refusal("oplus repair tie.wkt --fill odd -o out.wkt", "odd");
  expect_refusal("oplus repair square.wkt --json", "two outputs would go to standard output");
  expect_refusal("oplus repair square.wkt -o out.txt", "out.txt");
}

}  // namespace
}  // namespace oplus
