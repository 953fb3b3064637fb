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

TEST_F(Gen, the_seed_decides) {
  const std::string first = run("oplus gen grid --n 8 --seed 1").out;
  EXPECT_NE(first, "");
  EXPECT_EQ(run("oplus gen grid --n 8").out, first);
  EXPECT_EQ(run("oplus gen grid --n 8 --seed 1").out, first);
  EXPECT_NE(run("oplus gen grid --n 8 --seed 18446744073709551615").out, first);
}

TEST_F(Gen, refuses_unknown_families_and_invalid_options) {
  expect_refusal("oplus gen", "--list");
  expect_refusal("oplus gen nothing -o p.wkt", "'nothing'");
  expect_refusal("oplus gen star --n 2 -o p.wkt", "3 or more");
  for (const std::string n : {"-1", "three", "3.5", "", "1e3", "99999999999999999999", "10001"})
    expect_refusal("oplus gen star --n '" + n + "'", "--n");
  expect_refusal("oplus gen star --seed -1", "--seed");
  expect_refusal("oplus gen star --seed 18446744073709551616", "--seed");
  expect_refusal("oplus gen star --summand R", "--summand");
  expect_refusal("oplus gen star -o missing/p.wkt", "missing");
  expect_refusal("oplus gen star -o p.txt", "p.txt");
}

}  // namespace
}  // namespace oplus
