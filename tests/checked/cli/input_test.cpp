// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Input : public ShellWithRegions {
 protected:
  Input() {
    put("walls.wkt",
        "POLYGON ((0 0, 4 0, 4 1, 0 1, 0 0))\nPOLYGON ((0 3, 4 3, 4 4, 0 4, 0 3))\n"
        "POLYGON ((0 0, 1 0, 1 4, 0 4, 0 0))\nPOLYGON ((3 1, 4 1, 4 3, 3 3, 3 1))\n");
  }
};

TEST_F(Input, that_overlaps_is_refused_without_union) {
  expect_refusal("oplus sum walls.wkt square.wkt -o sum.wkt",
                 "outer chain of component 1 and outer chain of component 3 overlap");
  expect_output("oplus sum walls.wkt square.wkt --union",
                run("oplus sum frame.wkt square.wkt").out);
  expect_output("oplus verify walls.wkt square.wkt <(oplus sum frame.wkt square.wkt) --union",
                "yes\n");
  expect_output("oplus reflect walls.wkt --union | oplus compare - <(oplus reflect frame.wkt)",
                "equal\n");
}

/// All commands that read a region name --union and take it, with the answer for the union.
TEST_F(Input, with_union_is_taken_by_every_command) {
  put("frame.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))");
  put("sum.wkt", run("oplus sum frame.wkt square.wkt").out);
  for (const std::string command :
       {"sum R square.wkt", "nfp square.wkt R", "ifp R square.wkt", "erode R square.wkt",
        "open R square.wkt", "close R square.wkt", "complement R --format dat", "reflect R",
        "transform R --scale 2", "verify R square.wkt sum.wkt", "certify square.wkt R sum.wkt",
        "draw R square.wkt --view faces -o -"}) {
    const auto with = [&](const std::string& file) {
      std::string text = "oplus " + command;
      return text.replace(text.find('R'), 1, file);
    };
    const Ran right = run(with("frame.wkt"), 0);
    if (command.starts_with("reflect"))
      expect_output(with("walls.wkt --union") + " | oplus compare - <(" + with("frame.wkt") + ")",
                    "equal\n");
    else
      expect_output(with("walls.wkt") + " --union", right.out);
    expect_refusal(with("walls.wkt"), "; add --union to take their union\n");
  }
  expect_output(
      "oplus draw walls.wkt --union -o walls.svg && oplus draw frame.wkt -o frame.svg && "
      "diff <(sed s/walls/frame/ walls.svg) frame.svg",
      "");
  expect_refusal("oplus draw walls.wkt -o walls.svg", "; add --union to take their union\n");
  // A chain that is invalid alone stays so.
  const Ran tie = run("echo 'POLYGON((0 0,2 2,2 0,0 2,0 0))' | oplus reflect -");
  EXPECT_EQ(tie.err.find("--union"), std::string::npos) << tie.err;
}

TEST_F(Input, of_a_certificate_are_the_unions_as_transform_writes_them) {
  put("two.wkt", "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\nPOLYGON ((1 0, 3 0, 3 1, 1 1, 1 0))");
  expect_output(
      "oplus transform walls.wkt --scale 1 --union -o p.wkt && "
      "oplus transform two.wkt --scale 1 --union -o q.wkt && oplus sum p.wkt q.wkt -o s.wkt && "
      "oplus certify p.wkt q.wkt s.wkt -o right",
      "");
  expect_output("oplus certify walls.wkt two.wkt s.wkt --union", content("right"));
  expect_output("oplus sum walls.wkt two.wkt --union -o t.wkt --certificate certificate", "");
  EXPECT_EQ(content("certificate"), content("right"));
}

}  // namespace
}  // namespace oplus
