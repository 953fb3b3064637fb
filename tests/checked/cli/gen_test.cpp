// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference/families/family.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Gen : public Shell {};

TEST_F(Gen, lists_every_family) {
  const Ran ran = run("oplus gen --list", 0);
  EXPECT_EQ(static_cast<std::size_t>(std::count(ran.out.begin(), ran.out.end(), '\n')),
            families().size());
  for (const Family& family : families()) {
    EXPECT_TRUE(has("\n" + ran.out, "\n" + family.name + " "));
    EXPECT_TRUE(has(ran.out, " " + family.what + "\n"));
  }
}

TEST_F(Gen, writes_both_summands_of_every_family_in_every_format) {
  for (const Family& family : families()) {
    for (const std::string format : {"dat", "wkt", "geojson"}) {
      // --quiet: of fractions, a note says that other programs do not read them.
      const std::string gen = "oplus gen --quiet " + family.name + " --seed 5 ";
      expect_output("set -e\n" + gen + "-o p." + format + "\n" + gen + "--summand Q -o q." +
                        format + "\noplus compare p." + format + " <(" + gen +
                        "--summand P)\noplus compare q." + format + " <(" + gen + "--summand Q)",
                    "equal\nequal\n");
    }
  }
}

}  // namespace
}  // namespace oplus
