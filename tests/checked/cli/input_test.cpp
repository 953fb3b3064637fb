// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Input : public ShellWithRegions {};

/// All commands that read a region name --union and take it, with the answer for the union.
TEST_F(Input, with_union_is_taken_by_every_command) {
  put("walls.wkt",
      "POLYGON ((0 0, 4 0, 4 1, 0 1, 0 0))\nPOLYGON ((0 3, 4 3, 4 4, 0 4, 0 3))\n"
      "POLYGON ((0 0, 1 0, 1 4, 0 4, 0 0))\nPOLYGON ((3 1, 4 1, 4 3, 3 3, 3 1))\n");
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
}

}  // namespace
}  // namespace oplus
