// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.hpp"

#include <gtest/gtest.h>

#include "tests/bench/ratio.hpp"

namespace oplus {
namespace {

Measurement done(const std::string& engine, double seconds, const std::string& digest,
                 const std::string& area = "1") {
  Measurement m;
  m.engine = engine;
  m.seconds = seconds;
  m.peak_mb = 10;
  m.digest = digest;
  m.area = area;
  return m;
}

Measurement ended(const std::string& engine) {
  Measurement m;
  m.engine = engine;
  m.outcome = Outcome::over_limit;
  m.peak_mb = 30;
  return m;
}

RowReport row_of(std::vector<Measurement> measurements) {
  RowReport row;
  row.name = "row";
  row.measurements = std::move(measurements);
  return row;
}

TEST(Agreement, of_equal_digests) {
  const RowReport row = row_of({done("slide", 1, "a"), done("rca", 1, "a")});
  EXPECT_EQ(agreement_of(row).disagreement, "");
  ASSERT_NE(agreement_of(row).exact, nullptr);
  EXPECT_EQ(agreement_of(row).exact->engine, "slide");
}

TEST(Agreement, names_who_differs) {
  const RowReport row =
      row_of({done("slide", 1, "a"), done("rca", 1, "b"), done("cgal-reduced", 1, "a")});
  EXPECT_EQ(agreement_of(row).disagreement, "slide, cgal-reduced against rca");
}

TEST(Agreement, rounded_results_and_those_that_are_missing_do_not_count) {
  const RowReport row =
      row_of({ended("slide"), done("rca", 1, "a"), done("clipper", 1, "", "1.5")});
  EXPECT_EQ(agreement_of(row).disagreement, "");
  EXPECT_EQ(agreement_of(row).exact->engine, "rca");
  EXPECT_EQ(agreement_of(row_of({ended("slide")})).exact, nullptr);
}

TEST(AreaError, is_signed_absolute_and_relative) {
  const Measurement exact = done("slide", 1, "a", "10/4");
  EXPECT_EQ(absolute_area_error(done("clipper", 1, "", "2"), exact), -0.5);
  EXPECT_DOUBLE_EQ(relative_area_error(done("clipper", 1, "", "3"), exact), 0.2);
  EXPECT_EQ(relative_area_error(done("clipper", 1, "", "2.5"), exact), 0);
}

TEST(Ratio, is_a_lower_bound_where_an_engine_was_ended) {
  Report report;
  report.setting.limit = 8;
  const RowReport row = row_of({done("slide", 2, "a"), done("rca", 6, "a"), ended("winding")});
  EXPECT_EQ(ratio_text(*time_ratio(report, row, "rca", "slide")), "3.00");
  EXPECT_EQ(ratio_text(*time_ratio(report, row, "winding", "slide")), "> 4.00");
  EXPECT_EQ(ratio_text(*memory_ratio(report, row, "winding", "slide")), "> 3.00");
  EXPECT_FALSE(time_ratio(report, row, "slide", "winding"));
  EXPECT_FALSE(time_ratio(report, row, "clipper", "slide"));
}

TEST(Ratio, geometric_mean) {
  EXPECT_DOUBLE_EQ(geometric_mean({{2, false}, {8, false}}).value, 4);
  EXPECT_FALSE(geometric_mean({{2, false}, {8, false}}).is_lower_bound);
  EXPECT_TRUE(geometric_mean({{2, false}, {8, true}}).is_lower_bound);
}

TEST(Report, is_read_as_it_was_written) {
  Report report;
  report.setting = {"processor", 2, "compiler", "libraries", "command", 60, {"fork"}};
  Measurement m = done("cgal-reduced", 0.25, "abc", "1/3");
  m.seconds_evaluated = 0.5;
  m.segments = 12;
  m.runs = 3;
  m.busy = 0.99;
  m.outer = 1;
  m.holes = 2;
  m.vertices = 20;
  Measurement crashed;
  crashed.engine = "cgal-full";
  crashed.outcome = Outcome::crashed;
  crashed.note = "signal 11";
  report.rows = {row_of({m, crashed, ended("winding")})};
  report.rows[0].subject = Subject::growth;
  const nlohmann::ordered_json written = report;
  const Report read = nlohmann::ordered_json::parse(written.dump()).get<Report>();
  EXPECT_EQ(nlohmann::ordered_json(read), written);
  EXPECT_EQ(read.rows[0].subject, Subject::growth);
  ASSERT_NE(read.rows[0].done("cgal-reduced"), nullptr);
  EXPECT_EQ(read.rows[0].done("cgal-reduced")->seconds_evaluated, 0.5);
  EXPECT_EQ(read.rows[0].of("cgal-full")->note, "signal 11");
  EXPECT_EQ(read.rows[0].done("cgal-full"), nullptr);
  EXPECT_EQ(read.setting.missing, report.setting.missing);
}

}  // namespace
}  // namespace oplus
