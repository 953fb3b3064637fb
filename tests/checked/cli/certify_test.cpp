// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "tests/checked/cli/page_text.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class CertifyCommand : public ShellWithRegions {
 protected:
  CertifyCommand() {
    put("sum.wkt", "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0), (2 2, 2 3, 3 3, 3 2, 2 2))");
    put("filled.wkt", "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0))");
  }
};

TEST_F(CertifyCommand, writes_what_sum_writes_of_the_same_sum) {
  expect_output("oplus certify frame.wkt square.wkt sum.wkt -o one", "");
  expect_output("oplus sum frame.wkt square.wkt -o own.wkt --certificate other", "");
  EXPECT_EQ(content("one"), content("other"));
  EXPECT_TRUE(content("one").starts_with("oplus certificate 1\nunit 1\nsummand p\n"));
  EXPECT_TRUE(content("one").ends_with("\nend\n"));
  expect_output("oplus certify frame.wkt square.wkt sum.wkt", content("one"));
}

TEST_F(CertifyCommand, says_what_verify_says_if_it_is_not_the_sum) {
  const Ran verified = run("oplus verify frame.wkt square.wkt filled.wkt");
  expect_output("oplus certify frame.wkt square.wkt filled.wkt -o one", verified.out, 1);
  EXPECT_FALSE(files().contains("one"));
}

TEST_F(CertifyCommand, chains_that_touch_themselves_and_vertices_in_lines) {
  put("corner.wkt", "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((2 2, 3 2, 3 3, 2 3, 2 2)))");
  put("eight.wkt", "POLYGON ((0 0, 1 0, 2 0, 2 2, 4 2, 4 4, 2 4, 2 2, 0 2, 0 0))");
  const Ran ran = run("oplus certify corner.wkt square.wkt eight.wkt -o one");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.err, "1 chain touches itself"));
  EXPECT_TRUE(files().contains("one"));
}

TEST_F(CertifyCommand, a_vertex_may_not_repeat_the_one_before) {
  put("s.wkt", "POLYGON ((0 0, 0 0, 5 0, 5 5, 0 5, 0 0), (2 2, 2 3, 3 3, 3 2, 2 2))");
  const Ran ran = run("oplus certify frame.wkt square.wkt s.wkt -o one --quiet");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(has(ran.err, "S has the vertex (0, 0) twice in a row"));
  EXPECT_FALSE(files().contains("one"));
}

TEST_F(CertifyCommand, of_sums_of_other_kinds_there_are_none) {
  for (const std::string option : {"--open", "--digits 2"}) {
    const Ran ran = run("oplus sum frame.wkt square.wkt --certificate one " + option);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(has(ran.err, "--certificate is for "));
    EXPECT_TRUE(has(ran.err, "without " + option.substr(0, option.find(' '))));
    EXPECT_EQ(ran.lines_of_err(), 1);
    EXPECT_EQ(ran.out, "");
  }
  EXPECT_FALSE(files().contains("one"));
}

TEST_F(CertifyCommand, the_page_shows_what_its_command_prints) {
  const std::string page = text_of_file(source_root() / "docs/certificates.md");
  const std::vector<std::string> commands = commands_of(page);
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_TRUE(has(page, "\nprints\n\n```\n" + run(commands[0]).out + "```\n"));
}

TEST_F(CertifyCommand, two_outputs_to_one_place) {
  const Ran ran = run("oplus sum frame.wkt square.wkt -o one.wkt --certificate one.wkt");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(has(ran.err, "two outputs would go to one.wkt"));
}

}  // namespace
}  // namespace oplus
