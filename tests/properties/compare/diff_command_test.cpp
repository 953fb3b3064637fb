// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class DiffCommand : public Shell {
 protected:
  void SetUp() override {
    Shell::SetUp();
    put("square.dat", "4\n0 0\n1 0\n1 1\n0 1\n");
    put("frame.dat", "4\n0 0\n4 0\n4 4\n0 4\n1\n4\n1 1\n1 3\n3 3\n3 1\n");
  }

  Ran diff(const std::string& options) { return run("oplus-check diff " + options); }
};

TEST_F(DiffCommand, compares_pairs_and_says_what_ran_and_where_the_report_is) {
  const Ran ran = diff("--pair frame.dat square.dat --pair square.dat square.dat");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out,
                  "2 cases run, each closed and open, 0 skipped, 0 with a disagreement\n"
                  "report: oplus-findings/diff.json\n"));
  const auto report = nlohmann::json::parse(content("oplus-findings/diff.json"));
  EXPECT_EQ(report.at("all").at("ran"), 2);
  EXPECT_EQ(report.at("all").at("holes_in_sum"), 1);
  EXPECT_EQ(report.at("campaign").at("engines"),
            nlohmann::json({"slide", "rca", "loops", "winding"}));
  EXPECT_EQ(report.at("campaign").at("hole_test"), "all");
}

TEST_F(DiffCommand, makes_the_folder_of_counterexamples_and_no_other) {
  const std::string pair = "--pair frame.dat square.dat ";
  EXPECT_EQ(diff(pair + "--out new/folder/").exit_code, 0);
  EXPECT_TRUE(has(content("new/folder/diff.json"), "frame.dat"));
  EXPECT_EQ(diff(pair + "--out other --report ./other/r.md").exit_code, 0);
  EXPECT_EQ(diff(pair + "--report none/r.md").exit_code, 2);
  EXPECT_FALSE(files().contains("none"));
}

TEST_F(DiffCommand, says_what_hole_tests_were_asked) {
  const std::string pair = "--pair frame.dat square.dat";
  const Ran all = diff(pair);
  // One hole; closed and open; rca and loops.
  EXPECT_TRUE(has(all.out, "all hole tests gave the same answer 4 times about a face, "));
  const Ran ray = diff(pair + " --engine loops --hole-test ray");
  EXPECT_TRUE(has(ray.out, "the hole test ray was asked 2 times about a face, "));
  EXPECT_EQ(diff(pair + " --hole-test none").exit_code, 2);
}

TEST_F(DiffCommand, compares_families_the_same_for_the_same_seed) {
  const std::string options = "--family grid --family tight --cases 8 --seed 3 --report ";
  EXPECT_EQ(diff(options + "one.json").exit_code, 0);
  EXPECT_EQ(diff(options + "two.json --threads 1").exit_code, 0);
  EXPECT_EQ(content("one.json"), content("two.json"));
  EXPECT_EQ(nlohmann::json::parse(content("one.json")).at("sources").at(1).at("counts").at("ran"),
            8);
}

TEST_F(DiffCommand, counts_what_it_skips_and_does_not_pass_with_nothing_compared) {
  const Ran ran = diff("--pair frame.dat square.dat --largest 5");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(has(ran.out, "skipped: frame.dat square.dat: its convolution has"));
  EXPECT_TRUE(has(ran.out, "0 cases run, each closed and open, 1 skipped"));
}

TEST_F(DiffCommand, refuses_bad_input_and_requests_without_sense) {
  put("bad.dat", "4\n0 0\n2 2\n2 0\n0 2\n");
  const Ran bad = diff("--pair bad.dat square.dat");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_TRUE(has(bad.err, "bad.dat:4:1:"));
  EXPECT_EQ(diff("--family nonsense").exit_code, 2);
  EXPECT_EQ(diff("--pair square.dat").exit_code, 2);
  EXPECT_EQ(diff("--folder nowhere").exit_code, 2);
  EXPECT_EQ(diff("--engine nonsense").exit_code, 2);
  EXPECT_EQ(diff("--cases 0 --family grid").exit_code, 2);
}

TEST_F(DiffCommand, holds_a_program_of_somebody_else_to_account) {
  const Ran ran = diff("--pair square.dat frame.dat --engine 'exec:cat {p} #' --shrink-tries 20");
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_TRUE(has(ran.out, "the second is exec:cat {p} #: 1 outer chain"));
  EXPECT_TRUE(has(ran.out, "diff --engine 'exec:cat {p} #' --pair oplus-findings/"));
}

TEST_F(DiffCommand, agrees_with_a_program_that_is_right) {
  const Ran ran =
      // Sanitizers want more address space than any limit gives.
      diff(
          "--pair square.dat frame.dat --engine 'exec:oplus sum {p} {q} --format wkt' "
          "--memory-limit 0");
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_TRUE(has(ran.out,
                  "1 sum not taken by exec:oplus sum {p} {q} --format wkt, open: not taken: it "
                  "computes closed sums only\n"
                  "1 cases run, each closed and open but for 1 sum not taken, 0 skipped, 0 with"));
  const auto report = nlohmann::json::parse(content("oplus-findings/diff.json"));
  EXPECT_EQ(report.at("all").at("not_taken").size(), 1U);
}

TEST_F(DiffCommand, reports_how_a_program_ends_and_skips_what_it_does_not_take) {
  const Ran crash =
      diff("--pair square.dat frame.dat --engine 'exec:kill -SEGV $$ #' --shrink-tries 5");
  EXPECT_EQ(crash.exit_code, 1);
  EXPECT_TRUE(has(crash.out, "no sum\n  crashed: SIGSEGV"));
  const auto report = nlohmann::json::parse(content("oplus-findings/diff.json"));
  EXPECT_TRUE(report.at("counterexamples").contains("crashed: SIGSEGV"));
  const Ran hang = diff(
      "--pair square.dat frame.dat --engine 'exec:sleep 100000 #' --time-limit 0.2 --shrink 0");
  EXPECT_EQ(hang.exit_code, 1);
  const Ran none = diff("--pair square.dat frame.dat --engine 'exec:exit 77 #'");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_TRUE(has(none.out, "skipped: square.dat frame.dat: exec:exit 77 #: not taken"));
}

TEST_F(DiffCommand, lists_the_engines_of_others_in_its_help) {
  const Ran help = diff("--help");
  for (const char* part :
       {"cgal-reduced ", "cgal-greene ", "clipper ", "boost-polygon ", "exec:CMD "})
    EXPECT_TRUE(has(help.out, std::string("\n  ") + part));
  EXPECT_TRUE(has(diff("--engine cgal --family grid").err, "cgal-reduced"));
}

}  // namespace
}  // namespace oplus
