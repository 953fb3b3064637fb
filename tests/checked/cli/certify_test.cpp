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
  EXPECT_TRUE(content("one").starts_with("oplus certificate 2\nclaim sum\nunit 1\nsummand p\n"));
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
  const Ran ran = run("oplus certify corner.wkt square.wkt eight.wkt -o one", 0);
  EXPECT_TRUE(has(ran.err, "1 chain touches itself"));
  EXPECT_TRUE(files().contains("one"));
}

TEST_F(CertifyCommand, a_vertex_may_not_repeat_the_one_before) {
  put("s.wkt", "POLYGON ((0 0, 0 0, 5 0, 5 5, 0 5, 0 0), (2 2, 2 3, 3 3, 3 2, 2 2))");
  const Ran ran = run("oplus certify frame.wkt square.wkt s.wkt -o one --quiet", 2);
  EXPECT_TRUE(has(ran.err, "S has the vertex (0, 0) twice in a row"));
  EXPECT_FALSE(files().contains("one"));
}

TEST_F(CertifyCommand, writes_what_sum_writes_of_the_same_open_sum) {
  put("part.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  expect_output("oplus sum frame.wkt part.wkt --open -o open.wkt --certificate one", "");
  EXPECT_TRUE(content("one").starts_with("oplus certificate 2\nclaim open-sum\nunit 1\n"));
  EXPECT_TRUE(has(content("one"), " point 0 "));
  expect_output("oplus certify frame.wkt part.wkt open.wkt --open", content("one"));
  put("closed.wkt", "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0))");
  run("oplus certify frame.wkt part.wkt closed.wkt -o two", 0);
  const Ran verified = run("oplus verify frame.wkt part.wkt closed.wkt --open");
  expect_output("oplus certify frame.wkt part.wkt closed.wkt --open", verified.out, 1);
}

TEST_F(CertifyCommand, of_places) {
  expect_output("oplus nfp frame.wkt square.wkt -o nfp.wkt --certificate one", "");
  EXPECT_TRUE(content("one").starts_with("oplus certificate 2\nclaim nfp\nunit 1\n"));
  expect_output("oplus ifp frame.wkt square.wkt -o ifp.wkt --certificate two", "");
  EXPECT_TRUE(content("two").starts_with(
      "oplus certificate 2\nclaim ifp\nouter 1\n-21 -21 20 -21 20 20 -21 20\n"
      "outer-edges 0\nouter-points 0\nunit 1\n"))
      << content("two");
}

TEST_F(CertifyCommand, of_a_layout_that_is_right) {
  put("bin.wkt", "POLYGON ((0 0, 6 0, 6 4, 0 4, 0 0))");
  put("parts.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\nPOLYGON ((2 0, 4 0, 4 2, 2 2, 2 0))\n");
  run("oplus layout parts.wkt --container bin.wkt --certificate one", 0);
  EXPECT_EQ(content("one"),
            "oplus certificate 2\nclaim layout\nunit 1\n"
            "container\npoints 0\npieces 4\n0 4 5 3\n1 7 4 0\n2 3 5 6\n2 6 7 1\n"
            "part 0\npoints 0\npieces 1\n0 1 2 3\npart 1\npoints 0\npieces 1\n0 1 2 3\nend\n");
  run("oplus layout parts.wkt --certificate two", 0);
  EXPECT_TRUE(has(content("two"), "\ncontainer\npoints 0\npieces 0\npart 0\n"));
  const Ran wrong = run("oplus layout parts.wkt --container frame.wkt --certificate three", 1);
  EXPECT_TRUE(has(wrong.err, "there is no certificate of a layout that is wrong"));
  EXPECT_FALSE(files().contains("three"));
}

TEST_F(CertifyCommand, of_results_of_other_kinds_there_are_none) {
  put("parts.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  put("defect.wkt", "POLYGON ((9 0, 10 0, 9 1, 9 0))");
  put("line.wkt", "LINESTRING (0 0, 1 0)");
  put("empty.wkt", "POLYGON EMPTY");
  for (const std::string command :
       {"sum frame.wkt square.wkt --digits 2", "nfp frame.wkt square.wkt --grid 1/4",
        "nfp frame.wkt square.wkt --spacing 1", "ifp frame.wkt line.wkt", "nfp line.wkt square.wkt",
        "ifp frame.wkt empty.wkt", "layout parts.wkt --spacing 1", "layout parts.wkt --margin 1",
        "layout parts.wkt --tolerance 1", "layout parts.wkt --defects defect.wkt"}) {
    SCOPED_TRACE(command);
    const Ran ran = run("oplus " + command + " --certificate one --quiet", 2);
    EXPECT_TRUE(has(ran.err, "--certificate is for "));
    EXPECT_EQ(ran.lines_of_err(), 1);
    EXPECT_EQ(ran.out, "");
  }
  EXPECT_FALSE(files().contains("one"));
}

TEST_F(CertifyCommand, the_page_shows_what_its_commands_print) {
  const std::string page = text_of_file(source_root() / "docs/certificates.md");
  const std::vector<std::string> commands = commands_of(page);
  ASSERT_EQ(commands.size(), 2U);
  for (const std::string& command : commands)
    EXPECT_TRUE(has(page, "\nprints\n\n```\n" + run(command).out + "```\n"));
}

TEST_F(CertifyCommand, two_outputs_to_one_place) {
  const Ran ran = run("oplus sum frame.wkt square.wkt -o one.wkt --certificate one.wkt", 2);
  EXPECT_TRUE(has(ran.err, "two outputs would go to one.wkt"));
}

}  // namespace
}  // namespace oplus
