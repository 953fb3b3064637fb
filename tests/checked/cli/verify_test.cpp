// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class VerifyCommand : public ShellWithRegions {
 protected:
  VerifyCommand() {
    put("plug.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
    put("sum.wkt", "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0), (2 2, 2 3, 3 3, 3 2, 2 2))");
    put("filled.wkt", "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0))");
    put("less.wkt", "POLYGON ((0 0, 5 0, 5 4, 0 4, 0 0), (2 2, 2 3, 3 3, 3 2, 2 2))");
  }

  void expect_answer(const std::string& arguments, int exit_code, const std::string& text) const {
    expect_output("oplus verify " + arguments, text, exit_code);
  }

  /// Expects the answer no with all of these parts.
  void expect_no(const std::string& arguments, const std::vector<std::string>& parts) const {
    const Ran ran = run("oplus verify " + arguments, 1);
    for (const std::string& part : parts) EXPECT_TRUE(has(ran.out, part));
  }
};

TEST_F(VerifyCommand, yes) {
  expect_answer("frame.wkt square.wkt sum.wkt", 0, "yes\n");
  expect_answer("frame.wkt square.wkt - <sum.wkt", 0, "yes\n");
  expect_answer("square.wkt frame.wkt sum.wkt --open", 0, "yes\n");
}

TEST_F(VerifyCommand, no_with_the_reason_and_a_witness_outside_the_sum) {
  expect_answer("frame.wkt square.wkt filled.wkt", 1,
                "no: missing hole: a hole of area 1 of the sum is filled\n"
                "witness: (2.5, 2.5) is in S, but not in the sum: the interiors of P and "
                "-Q + (2.5, 2.5) do not meet\n");
}

TEST_F(VerifyCommand, no_with_points_that_add_up_to_the_witness) {
  expect_answer("frame.wkt square.wkt less.wkt", 1,
                "no: in the sum but not given: a place of area 5 of the sum is left out\n"
                "witness: (2.5, 4.5) is in the sum, but not in S: (2, 3.75) of P + (0.5, 0.75) of "
                "Q\n");
}

TEST_F(VerifyCommand, each_kind_of_reason_once_and_how_often) {
  put("turned.wkt",
      "MULTIPOLYGON (((0 0, 0 5, 5 5, 5 0, 0 0)), ((6 0, 7 0, 7 1, 6 0)), ((8 0, 9 0, 9 1, 8 0)))");
  expect_answer("frame.wkt square.wkt turned.wkt", 1,
                "no: missing hole: a hole of area 1 of the sum is filled\n"
                "witness: (2.5, 2.5) is in S, but not in the sum: the interiors of P and "
                "-Q + (2.5, 2.5) do not meet\n"
                "also: additional component: a component of area 0.5 is outside the sum; at (6.5, "
                "0.2)\n"
                "also: wrong orientation: the outer chain of component 1 runs clockwise, not "
                "counterclockwise; at (0, 2.5)\n"
                "in all: additional component, 2 times\n");
}

TEST_F(VerifyCommand, conventions_of_other_programs_are_noted) {
  put("s.wkt", "POLYGON ((0 0, 0 0, 3 0, 5 0, 5 5, 0 5, 0 0), (2 2, 2 3, 3 3, 3 2, 2 2))");
  expect_answer("frame.wkt square.wkt s.wkt", 0,
                "yes\nnote: 1 vertex repeats the one before\n"
                "note: 1 vertex is inside a straight line\n");
}

TEST_F(VerifyCommand, answers_in_json) {
  const Ran no = run("oplus verify frame.wkt square.wkt less.wkt --json", 1);
  const auto answer = nlohmann::json::parse(no.out);
  EXPECT_EQ(answer.at("answer"), "no");
  EXPECT_EQ(answer.at("boundary"), "closed");
  EXPECT_EQ(answer.at("witness"), (nlohmann::json{"2.5", "4.5"}));
  EXPECT_EQ(answer.at("reasons").size(), 1U);
  EXPECT_EQ(answer.at("reasons").at(0).at("kind"), "in the sum but not given");
  EXPECT_EQ(answer.at("reasons").at(0).at("in_sum"), true);
  EXPECT_EQ(answer.at("p").size(), 2U);
  EXPECT_EQ(answer.at("q").size(), 2U);
  const auto yes =
      nlohmann::json::parse(run("oplus verify frame.wkt square.wkt sum.wkt --json").out);
  EXPECT_EQ(yes.at("answer"), "yes");
  EXPECT_TRUE(yes.at("reasons").empty());
  EXPECT_FALSE(yes.contains("witness"));
}

TEST_F(VerifyCommand, draws_the_empty_intersection) {
  run("oplus verify frame.wkt square.wkt filled.wkt --svg x.svg", 1);
  const std::string picture = content("x.svg");
  EXPECT_TRUE(has(picture, "the interiors do not meet"));
  EXPECT_TRUE(has(picture, "witness"));
  run("oplus verify frame.wkt square.wkt sum.wkt --svg y.svg", 0);
  EXPECT_EQ(content("y.svg").find("witness"), std::string::npos);
}

TEST_F(VerifyCommand, within_a_tolerance) {
  put("near.wkt", "POLYGON ((0 0, 5.001 0, 5 5, 0 5, 0 0), (2 2, 2 3, 3 3, 3 2, 2 2))");
  expect_answer("frame.wkt square.wkt near.wkt --tolerance 1/1000", 0,
                "yes: the boundaries are within 1/1000 of each other\n"
                "distance: 0.001, at (5.001, 0) of the boundary of S\n"
                "components and holes correspond\n");
  expect_answer("frame.wkt square.wkt near.wkt --tolerance 0.00099", 1,
                "no: the boundaries are not within 0.00099 of each other\n"
                "distance: 0.001, at (5.001, 0) of the boundary of S\n"
                "the component at (0, 0) of the sum has no partner\n"
                "the component at (0, 0) that is given has no partner\n");
  // A part that is thinner than that may be lost, and is told; a hole in which a square of the diagonal 2D is
  // must be there.
  expect_answer("frame.wkt square.wkt filled.wkt --tolerance 0.7", 1,
                "no: the boundaries are not within 0.7 of each other\n"
                "distance: 2, at (2, 2) of the boundary of the sum\n"
                "the hole at (2, 2) of the sum has no partner\n");
  expect_answer("frame.wkt square.wkt filled.wkt --tolerance 3", 0,
                "yes: the sets differ only within 3 of the boundary of the sum\n"
                "distance: 2, at (2, 2) of the boundary of the sum\n"
                "the hole at (2, 2) of the sum has no partner, which this tolerance allows\n");
  // The hole's corners are 2 from the boundary of S, whose corner is 0.001 from that of the sum.
  put("moved.wkt", "POLYGON ((0 0, 5.001 0, 5 5, 0 5, 0 0))");
  expect_answer("frame.wkt square.wkt moved.wkt --tolerance 1.5", 0,
                "yes: the sets differ only within 1.5 of the boundary of the sum\n"
                "distance of the boundary of S from it: 0.001, at (5.001, 0) of the boundary of S\n"
                "the hole at (2, 2) of the sum has no partner, which this tolerance allows\n");
  const auto only_near = nlohmann::json::parse(
      run("oplus verify frame.wkt square.wkt moved.wkt --tolerance 1.5 --json").out);
  EXPECT_EQ(only_near.at("within"), false);
  EXPECT_EQ(only_near.at("distance").at("squared_at_most"), "0.000001");
  const auto json = nlohmann::json::parse(
      run("oplus verify frame.wkt square.wkt near.wkt --tolerance 1e-3 --json").out);
  EXPECT_EQ(json.at("answer"), "yes");
  EXPECT_EQ(json.at("distance").at("squared_at_least"), "0.000001");
}

TEST_F(VerifyCommand, refuses_what_it_cannot_read) {
  put("text.wkt", "no sum at all");
  put("crossing.wkt", "POLYGON ((0 0, 5 5, 5 0, 0 5, 0 0))");
  expect_refusal("oplus verify frame.wkt square.wkt", "S");
  expect_refusal("oplus verify frame.wkt square.wkt missing.wkt", "missing.wkt");
  expect_refusal("oplus verify frame.wkt square.wkt text.wkt", "text.wkt:1:1");
  expect_refusal("oplus verify crossing.wkt square.wkt sum.wkt", "crossing.wkt");
  expect_refusal("oplus verify - square.wkt - <sum.wkt", "standard input");
  expect_refusal("oplus verify frame.wkt square.wkt sum.wkt --tolerance -1", "negative");
  expect_refusal("oplus verify frame.wkt square.wkt sum.wkt --tolerance wide", "not a number");
  expect_refusal("oplus verify frame.wkt square.wkt sum.wkt --svg none/x.svg", "none");
  expect_refusal("oplus verify frame.wkt square.wkt sum.wkt --svg x.png", "FILE.svg");
  expect_refusal("oplus verify frame.wkt square.wkt sum.wkt >/dev/full", "standard output");
}

}  // namespace
}  // namespace oplus
