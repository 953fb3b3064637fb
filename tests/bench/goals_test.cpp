// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/bench/page.hpp"

namespace oplus {
namespace {

Measurement of(const std::string& engine, double seconds) {
  return {.engine = engine,
          .area = "1",
          .numbers = {{"seconds", seconds}, {"peak_mb", 1}, {"segments", 1'000'000}}};
}

Row row_of(const std::string& name, const std::string& group,
           std::vector<Measurement> measurements) {
  return {.name = name, .group = group, .what = name, .measurements = std::move(measurements)};
}

/// The measured value, and whether the goal is reached.
using Found = std::pair<std::string, std::string>;

Found goal(const Rows& rows, const std::string& part_of_text) {
  for (const auto& cells : goals_of({.setting = {.limit = 60}, .rows = rows}).rows)
    if (cells[0].find(part_of_text) != std::string::npos) return {cells[1], cells[2]};
  throw std::out_of_range(part_of_text);
}

TEST(Goals, without_a_run_are_neither_reached_nor_missed) {
  const Table goals = goals_of({});
  EXPECT_EQ(goals.rows.size(), 21U);
  for (const auto& cells : goals.rows) EXPECT_EQ(cells.at(2), "not measured") << cells[0];
}

TEST(Goals, are_reached_at_their_number) {
  const auto small_pairs = [](double seconds) {
    return goal(
        {row_of("small_pairs", "small pairs", {of("slide", 1), of("cgal-reduced", seconds)})},
        "small pairs");
  };
  EXPECT_EQ(small_pairs(10), Found("10.0", "yes"));
  EXPECT_EQ(small_pairs(9.9), Found("9.90", "**no**"));
}

TEST(Goals, a_lower_bound_below_the_goal_decides_nothing) {
  Measurement ended = of("cgal-reduced", 0);
  ended.outcome = Measurement::Ending::over_limit;
  const auto stars = [&](double slide) {
    return goal({row_of("star_300_star_100", "stars", {of("slide", slide), ended})},
                "stars of 300 and 100: at least");
  };
  EXPECT_EQ(stars(1), Found("> 60.0", "yes"));
  EXPECT_EQ(stars(2), Found("> 30.0", "not measured"));
}

TEST(Goals, name_the_row_on_which_an_engine_is_faster) {
  const auto row = [](double clipper) {
    return goal({row_of("comb_20", "combs", {of("slide", 1), of("clipper", clipper)})}, "no row");
  };
  EXPECT_EQ(row(1), Found("none", "yes"));
  EXPECT_EQ(row(0.5), Found("comb_20: clipper, 0.500", "**no**"));
}

TEST(Goals, the_time_per_segment_counts_without_holes) {
  const auto row = [](double seconds, double holes) {
    Measurement slide = of("slide", seconds);
    slide.numbers["sum_holes"] = holes;
    return goal({row_of("comb_20", "combs", {slide})}, "sums without holes");
  };
  EXPECT_EQ(row(3, 0), Found("at most 3.00, comb_20", "yes"));
  EXPECT_EQ(row(3.1, 0), Found("at most 3.10, comb_20", "**no**"));
  EXPECT_EQ(row(3.1, 1), Found("", "not measured"));
}

TEST(Goals, of_hard_pairs_are_of_their_group) {
  const auto row = [](const std::string& group, double seconds) {
    return goal({row_of("dots_300", group, {of("slide", seconds)})}, "hard pairs");
  };
  EXPECT_EQ(row("hard", 10), Found("at most 10.0, dots_300", "yes"));
  EXPECT_EQ(row("hard", 11), Found("at most 11.0, dots_300", "**no**"));
  EXPECT_EQ(row("combs", 11), Found("", "not measured"));
}

TEST(Goals, of_whole_commands_spare_ten_milliseconds) {
  const auto row = [](double command) {
    Row made = row_of("fork_100", "commands", {of("slide", 1), of("oplus-sum", command)});
    made.subject = Subject::commands;
    return goal({made}, "whole command");
  };
  EXPECT_EQ(row(1.31), Found("at most 1.30, fork_100", "yes"));
  EXPECT_EQ(row(1.4), Found("at most 1.39, fork_100", "**no**"));
}

TEST(Goals, compare_open_sums_and_verify_with_slide) {
  const Rows rows = {
      row_of("comb_20", "combs", {of("slide", 1), of("slide-open", 2.5), of("verify", 19)})};
  EXPECT_EQ(goal(rows, "open sums"), Found("at most 2.50, comb_20", "**no**"));
  EXPECT_EQ(goal(rows, "verify"), Found("at most 19.0, comb_20", "yes"));
}

TEST(Goals, count_an_engine_that_was_stopped_as_unknown_or_missed) {
  Measurement stopped = of("verify", 0);
  stopped.outcome = Measurement::Ending::over_limit;
  const auto rows = [&](double slide) {
    return Rows{row_of("comb_20", "combs", {of("slide", 1), of("verify", 19)}),
                row_of("dots_300", "hard", {of("slide", slide), stopped})};
  };
  EXPECT_EQ(goal(rows(6), "verify"), Found("at most 19.0, comb_20", "not measured"));
  EXPECT_EQ(goal(rows(2), "verify"), Found("> 30.0, dots_300", "**no**"));
}

/// A row of certificates.
Row certificates(std::vector<Measurement> measurements) {
  Row row = row_of("certificate_fork_50", "certificates", std::move(measurements));
  row.subject = Subject::certificates;
  return row;
}

TEST(Goals, of_checking_compare_with_a_program_of_cgal) {
  const auto checked = [](double seconds) {
    return certificates({of("oplus-certified", seconds), of("cgal-sum", 1)});
  };
  EXPECT_EQ(goal({checked(0.5), checked(1)}, "checked"), Found("1.00, certificate_fork_50", "yes"));
  EXPECT_EQ(goal({checked(2), checked(1)}, "checked"),
            Found("0.500, certificate_fork_50", "**no**"));
}

TEST(Goals, of_checking_are_not_measured_without_every_row) {
  Measurement missing = of("oplus-certified", 0);
  missing.outcome = Measurement::Ending::unsupported;
  const Row done = certificates({of("oplus-certified", 0.5), of("cgal-sum", 1)});
  EXPECT_EQ(goal({done}, "checked"), Found("2.00, certificate_fork_50", "yes"));
  EXPECT_EQ(goal({done, certificates({missing, of("cgal-sum", 1)})}, "checked"),
            Found("", "not measured"));
}

TEST(Goals, of_making_certificates_spare_a_tenth_of_a_second) {
  const auto made = [](double seconds) {
    return goal(
        {certificates({of("slide", 9), of("oplus-sum", 1), of("sum-certificate", seconds)})},
        "made");
  };
  EXPECT_EQ(made(10.1), Found("at most 10.0, certificate_fork_50", "yes"));
  EXPECT_EQ(made(10.2), Found("at most 10.1, certificate_fork_50", "**no**"));
}

TEST(Goals, of_the_size_of_certificates_count_segments_of_slide) {
  const auto sized = [](double bytes) {
    Measurement made = of("sum-certificate", 1);
    made.numbers["zipped_bytes"] = bytes;
    return goal({certificates({of("slide", 1), made})}, "gzip");
  };
  EXPECT_EQ(sized(200e6), Found("at most 200, certificate_fork_50", "yes"));
  EXPECT_EQ(sized(201e6), Found("at most 201, certificate_fork_50", "**no**"));
}

TEST(Goals, for_published_pairs_use_the_mean_and_the_least) {
  const Rows rows = {row_of("a", "published", {of("slide", 1), of("cgal-reduced", 2.5)}),
                     row_of("b", "published", {of("slide", 1), of("cgal-reduced", 50)})};
  EXPECT_EQ(goal(rows, "geometric mean"), Found("11.2", "yes"));
  EXPECT_EQ(goal(rows, "none less"), Found("2.50, a", "**no**"));
}

}  // namespace
}  // namespace oplus
