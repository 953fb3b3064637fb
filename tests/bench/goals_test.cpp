// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/goals.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace oplus {
namespace {

Measurement of(const std::string& engine, double seconds) {
  Measurement m;
  m.engine = engine;
  m.numbers = {{"seconds", seconds}, {"peak_mb", 1}, {"segments", 1'000'000}};
  m.area = "1";
  return m;
}

Report report_of(const std::string& row, const std::string& group,
                 std::vector<Measurement> measurements) {
  Row report;
  report.name = row;
  report.group = group;
  report.what = row;
  report.measurements = std::move(measurements);
  return {{"", 1, "", "", "", "", 60, {}}, {report}};
}

Goal goal(const Report& report, const std::string& part_of_text) {
  const std::vector<Goal> goals = goals_of(report);
  const auto found = std::find_if(goals.begin(), goals.end(), [&](const Goal& g) {
    return g.text.find(part_of_text) != std::string::npos;
  });
  if (found == goals.end()) throw std::out_of_range(part_of_text);
  return *found;
}

TEST(Goals, without_a_run_are_neither_reached_nor_missed) {
  for (const Goal& each : goals_of({})) EXPECT_EQ(each.reached, std::nullopt) << each.text;
}

TEST(Goals, are_reached_from_the_number_on) {
  const auto small_pairs = [](double seconds) {
    return goal(
        report_of("small_pairs", "small pairs", {of("slide", 1), of("cgal-reduced", seconds)}),
        "small pairs");
  };
  EXPECT_EQ(small_pairs(20).reached, true);
  EXPECT_EQ(small_pairs(19.9).reached, false);
  EXPECT_EQ(small_pairs(19.9).measured, "19.9");
}

TEST(Goals, a_lower_bound_below_the_number_tells_nothing) {
  Measurement ended = of("cgal-reduced", 0);
  ended.outcome = Measurement::Outcome::over_limit;
  const auto stars = [&](double slide) {
    return goal(report_of("star_300_star_100", "stars", {of("slide", slide), ended}),
                "stars of 300 and 100: at least");
  };
  EXPECT_EQ(stars(1).reached, true);
  EXPECT_EQ(stars(2).reached, std::nullopt);
}

TEST(Goals, name_the_row_on_which_an_engine_is_faster) {
  const auto row = [](double clipper) {
    return goal(report_of("comb_20", "combs", {of("slide", 1), of("clipper", clipper)}), "no row");
  };
  EXPECT_EQ(row(1).reached, true);
  EXPECT_EQ(row(0.5).reached, false);
  EXPECT_EQ(row(0.5).measured, "comb_20: clipper, 0.500");
}

TEST(Goals, the_time_a_segment_counts_where_there_are_no_holes) {
  const auto row = [](double seconds, double holes) {
    Measurement slide = of("slide", seconds);
    slide.numbers["sum_holes"] = holes;
    return goal(report_of("comb_20", "combs", {slide}), "µs a segment");
  };
  EXPECT_EQ(row(3, 0).reached, true);
  EXPECT_EQ(row(3.1, 0).reached, false);
  EXPECT_EQ(row(3.1, 1).reached, std::nullopt);
}

TEST(Goals, of_the_published_pairs_are_about_the_mean_and_the_least) {
  Report report = report_of("a", "published", {of("slide", 1), of("cgal-reduced", 2)});
  const Report second = report_of("b", "published", {of("slide", 1), of("cgal-reduced", 50)});
  report.rows.push_back(second.rows[0]);
  EXPECT_EQ(goal(report, "geometric mean").reached, true);
  EXPECT_EQ(goal(report, "none less").reached, false);
  EXPECT_EQ(goal(report, "none less").measured, "2.00, a");
}

}  // namespace
}  // namespace oplus
