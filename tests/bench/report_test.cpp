// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace oplus {
namespace {

Measurement done(const std::string& engine, double seconds, const std::string& digest,
                 const std::string& area = "1") {
  return {.engine = engine,
          .digest = digest,
          .area = area,
          .numbers = {{"seconds", seconds}, {"peak_mb", 10}}};
}

Measurement stopped(const std::string& engine) {
  return {
      .engine = engine, .outcome = Measurement::Ending::over_limit, .numbers = {{"peak_mb", 30}}};
}

Measurement crashed(const std::string& engine) {
  return {.engine = engine, .outcome = Measurement::Ending::crashed, .note = "signal 6"};
}

Row row_of(std::vector<Measurement> measurements) {
  return {.name = "row", .measurements = std::move(measurements)};
}

TEST(Agreement, of_equal_digests) {
  const Row row = row_of({done("slide", 1, "a"), done("rca", 1, "a")});
  EXPECT_EQ(agreement_of(row).disagreement, "");
  ASSERT_NE(agreement_of(row).exact, nullptr);
  EXPECT_EQ(agreement_of(row).exact->engine, "slide");
}

TEST(Agreement, names_the_engines_that_differ) {
  const Row row =
      row_of({done("slide", 1, "a"), done("rca", 1, "b"), done("cgal-reduced", 1, "a")});
  EXPECT_EQ(agreement_of(row).disagreement, "slide, cgal-reduced against rca");
}

TEST(Agreement, rounded_and_missing_results_do_not_count) {
  const Row row = row_of({stopped("slide"), done("rca", 1, "a"), done("clipper", 1, "", "1.5")});
  EXPECT_EQ(agreement_of(row).disagreement, "");
  EXPECT_EQ(agreement_of(row).exact->engine, "rca");
  EXPECT_EQ(agreement_of(row_of({stopped("slide")})).exact, nullptr);
}

TEST(AreaError, is_signed_absolute_and_relative) {
  const auto error = [](const std::string& area, const std::string& name) {
    return row_of({done("slide", 1, "a", "10/4"), done("clipper", 1, "", area)})
        .number("clipper." + name);
  };
  EXPECT_EQ(error("2", "area_error"), -0.5);
  EXPECT_DOUBLE_EQ(*error("3", "relative_area_error"), 0.2);
  EXPECT_EQ(error("2.5", "relative_area_error"), 0);
  EXPECT_EQ(row_of({done("clipper", 1, "", "2")}).number("clipper.area_error"), std::nullopt);
}

TEST(Ratio, is_a_lower_bound_if_an_engine_was_stopped) {
  const Row row = row_of({done("slide", 2, "a"), done("rca", 6, "a"), stopped("winding")});
  EXPECT_EQ(ratio_text(*ratio(row, "seconds", "rca", "slide", 8)), "3.00");
  EXPECT_EQ(ratio_text(*ratio(row, "seconds", "winding", "slide", 8)), "> 4.00");
  EXPECT_EQ(ratio_text(*ratio(row, "peak_mb", "winding", "slide", 8)), "> 3.00");
  EXPECT_FALSE(ratio(row, "seconds", "slide", "winding", 8));
  EXPECT_FALSE(ratio(row, "seconds", "clipper", "slide", 8));
}

TEST(Ratio, geometric_mean) {
  EXPECT_DOUBLE_EQ(geometric_mean({{2, false}, {8, false}}).value, 4);
  EXPECT_FALSE(geometric_mean({{2, false}, {8, false}}).is_lower_bound);
  EXPECT_TRUE(geometric_mean({{2, false}, {8, true}}).is_lower_bound);
}

TEST(Faults, are_disagreements_and_failures_of_our_engines) {
  const auto faults = [](std::vector<Measurement> all) { return faults_of(row_of(all)); };
  Measurement lost = stopped("winding");
  EXPECT_TRUE(faults({done("slide", 1, "a"), lost}).empty());
  lost.outcome = Measurement::Ending::out_of_memory;
  EXPECT_TRUE(faults({lost}).empty());
  EXPECT_EQ(faults({done("slide", 1, "a"), done("rca", 1, "b"), crashed("winding")}),
            std::vector<std::string>(
                {"row: slide against rca disagree", "row: winding crashed: signal 6"}));
  EXPECT_TRUE(faults({crashed("cgal-full")}).empty());
}

TEST(Report, is_read_as_written) {
  Report report{
      .setting = {"processor", 2, "compiler", "libraries", "commit", "command", 60, {"fork"}},
      .rows = {row_of(
          {done("cgal-reduced", 0.25, "abc", "1/3"), crashed("cgal-full"), stopped("winding")})}};
  for (const Subject subject : {Subject::sums, Subject::growth, Subject::commands,
                                Subject::convolution, Subject::hole_tests}) {
    report.rows[0].subject = subject;
    EXPECT_EQ(report_of(to_json(report)).rows[0].subject, subject);
  }
  const std::string written = to_json(report);
  const Report read = report_of(written);
  EXPECT_EQ(to_json(read), written);
  EXPECT_EQ(read.rows[0].number("cgal-reduced.seconds"), 0.25);
  EXPECT_EQ(read.rows[0].of("cgal-full")->note, "signal 6");
  EXPECT_EQ(read.rows[0].done("cgal-full"), nullptr);
  EXPECT_EQ(read.setting.missing, report.setting.missing);
  EXPECT_THROW(report_of("{}"), std::invalid_argument);
  EXPECT_THROW(report_of("no JSON"), std::invalid_argument);
}

}  // namespace
}  // namespace oplus
