// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/goals.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "tests/bench/engine.hpp"
#include "tests/bench/numbers.hpp"
#include "tests/bench/ratio.hpp"

namespace oplus {

namespace {

const std::string cgal = "cgal-reduced";

const RowReport* row_named(const Report& report, const std::string& name) {
  const auto found = std::find_if(report.rows.begin(), report.rows.end(),
                                  [&](const RowReport& row) { return row.name == name; });
  return found == report.rows.end() ? nullptr : &*found;
}

using RatioOf = std::optional<Ratio>(const Report& report, const RowReport& row,
                                     const std::string& engine, const std::string& base);

std::optional<Ratio> ratio_on(const Report& report, const std::string& row, RatioOf ratio_of) {
  const RowReport* found = row_named(report, row);
  return found == nullptr ? std::nullopt : ratio_of(report, *found, cgal, "slide");
}

/// A lower bound that is below the goal tells nothing.
Goal at_least(std::string text, const std::optional<Ratio>& ratio, double goal) {
  if (!ratio) return {std::move(text), "", std::nullopt};
  Goal result{std::move(text), ratio_text(*ratio), ratio->value >= goal};
  if (ratio->is_lower_bound && ratio->value < goal) result.reached = std::nullopt;
  return result;
}

Goal row_goal(const Report& report, const std::string& what, const std::string& row, int goal) {
  return at_least(what + ": at least " + std::to_string(goal) +
                      " times as fast as CGAL's reduced " + "convolution",
                  ratio_on(report, row, time_ratio), goal);
}

Goal memory_goal(const Report& report, const std::string& what, const std::string& row) {
  return at_least(what + ": at most a tenth of CGAL's memory", ratio_on(report, row, memory_ratio),
                  10);
}

struct RowRatio {
  std::string what;
  Ratio ratio;
};

bool is_slower(const RowRatio& a, const RowRatio& b) { return a.ratio.value < b.ratio.value; }

std::vector<RowRatio> ratios_of_group(const Report& report, const std::string& group) {
  std::vector<RowRatio> ratios;
  for (const RowReport& row : report.rows) {
    if (row.group != group) continue;
    if (const auto ratio = time_ratio(report, row, cgal, "slide"))
      ratios.push_back({row.what, *ratio});
  }
  return ratios;
}

void add_published(const Report& report, std::vector<Goal>& goals) {
  const std::vector<RowRatio> found = ratios_of_group(report, "published");
  std::vector<Ratio> ratios;
  for (const RowRatio& of_row : found) ratios.push_back(of_row.ratio);
  goals.push_back(at_least("published pairs: at least 8 times, geometric mean",
                           ratios.empty() ? std::nullopt : std::optional(geometric_mean(ratios)),
                           8));
  const auto least = std::min_element(found.begin(), found.end(), is_slower);
  goals.push_back(at_least("published pairs: none less than 3 times",
                           found.empty() ? std::nullopt : std::optional(least->ratio), 3));
  if (!found.empty()) goals.back().measured += ", " + least->what;
}

/// Rows of sums on which an engine of others, or of ours, takes less time than slide.
Goal none_is_faster(const Report& report, std::string text,
                    const std::function<bool(const RowReport& row)>& counts) {
  std::string faster;
  bool measured = false;
  for (const RowReport* row : rows_for(report, Subject::sums)) {
    if (!counts(*row)) continue;
    for (const Measurement& m : row->measurements) {
      const auto ratio = time_ratio(report, *row, m.engine, "slide");
      if (m.engine == "slide" || m.engine == "slide2" || !ratio) continue;
      measured = true;
      if (!ratio->is_lower_bound && ratio->value < 1)
        faster += (faster.empty() ? "" : "; ") + row->what + ": " + m.engine + ", " +
                  three_digits(ratio->value);
    }
  }
  if (!measured) return {std::move(text), "", std::nullopt};
  return {std::move(text), faster.empty() ? "none" : faster, faster.empty()};
}

/// The largest number of microseconds a segment on rows without holes.
Goal time_a_segment(const Report& report) {
  Goal goal{"where the sum has no holes: at most 3 µs a segment of the reduced convolution", "",
            std::nullopt};
  double largest = 0;
  for (const RowReport& row : report.rows) {
    const Measurement* m = row.done("slide");
    if (m == nullptr || m->holes > 0 || m->segments.value_or(0) == 0) continue;
    const double of_row = 1e6 * m->seconds / static_cast<double>(*m->segments);
    if (of_row < largest) continue;
    largest = of_row;
    goal.measured = "at most " + three_digits(of_row) + ", " + row.what;
    goal.reached = of_row <= 3;
  }
  return goal;
}

Goal two_threads(const Report& report) {
  std::vector<Ratio> ratios;
  for (const RowReport* row : rows_for(report, Subject::growth))
    if (const auto ratio = time_ratio(report, *row, "slide", "slide2")) ratios.push_back(*ratio);
  return at_least("two threads: at least 1.7 times one, on the largest sum of the growth",
                  ratios.empty() ? std::nullopt : std::optional(ratios.back()), 1.7);
}

}  // namespace

std::vector<Goal> goals_of(const Report& report) {
  std::vector<Goal> goals{
      row_goal(report, "stars of 300 and 100", "star_300_star_100", 50),
      row_goal(report, "stars of 100 and 100", "star_100_star_100", 25),
      memory_goal(report, "stars of 300 and 100", "star_300_star_100"),
      memory_goal(report, "stars of 100 and 100", "star_100_star_100"),
      row_goal(report, "simple polygons of 200 and 100", "simple_200_simple_100", 25),
      row_goal(report, "fork of 50 teeth and L", "fork_50", 8),
      none_is_faster(report, "fork of 50 teeth and L: no engine is faster",
                     [](const RowReport& row) { return row.name == "fork_50"; }),
  };
  add_published(report, goals);
  goals.push_back(row_goal(report, "small pairs", "small_pairs", 20));
  goals.push_back(none_is_faster(report, "no row on which any engine is faster",
                                 [](const RowReport&) { return true; }));
  goals.push_back(time_a_segment(report));
  goals.push_back(two_threads(report));
  return goals;
}

}  // namespace oplus
