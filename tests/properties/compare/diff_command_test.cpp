// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "properties/runner/child_process.hpp"
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

  Ran diff(const std::string& options) {
    return run("'" + program_beside("oplus-check") + "' diff " + options);
  }
};

TEST_F(DiffCommand, compares_pairs_and_says_what_ran_and_where_the_report_is) {
  const Ran ran = diff("--pair frame.dat square.dat --pair square.dat square.dat");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_NE(ran.out.find("2 cases run, each closed and open, 0 skipped, 0 with a disagreement\n"
                         "report: oplus-findings/diff.json\n"),
            std::string::npos)
      << ran.out;
  const auto report = nlohmann::json::parse(content("oplus-findings/diff.json"));
  EXPECT_EQ(report.at("all").at("ran"), 2);
  EXPECT_EQ(report.at("all").at("holes_in_sum"), 1);
  EXPECT_EQ(report.at("campaign").at("engines"),
            nlohmann::json({"slide", "rca", "loops", "winding"}));
  EXPECT_EQ(report.at("campaign").at("hole_test"), "all");
}

TEST_F(DiffCommand, says_what_hole_tests_were_asked) {
  const std::string pair = "--pair frame.dat square.dat";
  const Ran all = diff(pair);
  // One hole; closed and open; rca and loops.
  EXPECT_NE(all.out.find("all hole tests gave the same answer 4 times about a face, "),
            std::string::npos)
      << all.out;
  const Ran ray = diff(pair + " --engine loops --hole-test ray");
  EXPECT_NE(ray.out.find("the hole test ray was asked 2 times about a face, "), std::string::npos)
      << ray.out;
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
  EXPECT_NE(ran.out.find("skipped: frame.dat square.dat: its convolution has"), std::string::npos);
  EXPECT_NE(ran.out.find("0 cases run, each closed and open, 1 skipped"), std::string::npos);
}

TEST_F(DiffCommand, refuses_bad_input_and_requests_without_sense) {
  put("bad.dat", "4\n0 0\n2 2\n2 0\n0 2\n");
  const Ran bad = diff("--pair bad.dat square.dat");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_NE(bad.err.find("bad.dat:4:1:"), std::string::npos) << bad.err;
  EXPECT_EQ(diff("--family nonsense").exit_code, 2);
  EXPECT_EQ(diff("--pair square.dat").exit_code, 2);
  EXPECT_EQ(diff("--folder nowhere").exit_code, 2);
  EXPECT_EQ(diff("--engine nonsense").exit_code, 2);
  EXPECT_EQ(diff("--cases 0 --family grid").exit_code, 2);
}

TEST_F(DiffCommand, holds_a_program_of_somebody_else_to_account) {
  const Ran ran = diff("--pair square.dat frame.dat --engine 'exec:cat {p} #' --shrink-tries 20");
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_NE(ran.out.find("the second is exec:cat {p} #: 1 outer chain"), std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("diff --engine 'exec:cat {p} #' --pair oplus-findings/"),
            std::string::npos)
      << ran.out;
}

TEST_F(DiffCommand, agrees_with_a_program_that_is_right) {
  const Ran ran =
      // Sanitizers want more address space than any limit gives.
      diff(
          "--pair square.dat frame.dat --engine 'exec:oplus sum {p} {q} --format wkt' "
          "--memory-limit 0");
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_NE(
      ran.out.find("1 sum not taken by exec:oplus sum {p} {q} --format wkt, open: not taken: it "
                   "computes closed sums only\n"
                   "1 cases run, each closed and open but for 1 sum not taken, 0 skipped, 0 with"),
      std::string::npos)
      << ran.out;
  const auto report = nlohmann::json::parse(content("oplus-findings/diff.json"));
  EXPECT_EQ(report.at("all").at("not_taken").size(), 1U);
}

TEST_F(DiffCommand, reports_how_a_program_ends_and_skips_what_it_does_not_take) {
  const Ran crash =
      diff("--pair square.dat frame.dat --engine 'exec:kill -SEGV $$ #' --shrink-tries 5");
  EXPECT_EQ(crash.exit_code, 1);
  EXPECT_NE(crash.out.find("no sum\n  crashed: SIGSEGV"), std::string::npos) << crash.out;
  const auto report = nlohmann::json::parse(content("oplus-findings/diff.json"));
  EXPECT_TRUE(report.at("counterexamples").contains("crashed: SIGSEGV"));
  const Ran hang = diff(
      "--pair square.dat frame.dat --engine 'exec:sleep 100000 #' --time-limit 0.2 --shrink 0");
  EXPECT_EQ(hang.exit_code, 1);
  const Ran none = diff("--pair square.dat frame.dat --engine 'exec:exit 77 #'");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.out.find("skipped: square.dat frame.dat: exec:exit 77 #: not taken"),
            std::string::npos)
      << none.out;
}

TEST_F(DiffCommand, lists_the_engines_of_others_in_its_help) {
  const Ran help = diff("--help");
  for (const char* part :
       {"cgal-reduced ", "cgal-greene ", "clipper ", "boost-polygon ", "exec:CMD "})
    EXPECT_NE(help.out.find(std::string("\n  ") + part), std::string::npos) << part;
  EXPECT_NE(diff("--engine cgal --family grid").err.find("cgal-reduced"), std::string::npos);
}

}  // namespace
}  // namespace oplus
