// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/goals.hpp"

#include <algorithm>
#include <utility>

#include "tests/bench/numbers.hpp"

namespace oplus {

namespace {

/// A lower bound that is below the goal tells nothing.
Goal at_least(double goal, std::string text, const std::optional<Ratio>& ratio) {
  if (!ratio) return {std::move(text), "", std::nullopt};
  const bool is_unknown = ratio->is_lower_bound && ratio->value < goal;
  return {std::move(text), ratio_text(*ratio),
          is_unknown ? std::nullopt : std::optional(ratio->value >= goal)};
}

/// The other rows on which an engine of others, or of ours, takes less time than slide.
Goal none_is_faster(std::string text, const Rows& rows, double limit) {
  std::string faster;
  bool measured = false;
  for (const Row* row : rows) {
    for (const Measurement& m : row->measurements) {
      const auto ratio = time_ratio(*row, m.engine, "slide", limit);
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
  Goal goal{
      "where the sum has no holes: at most 3 µs a segment of the reduced convolution", "", {}};
  double largest = 0;
  for (const Row& row : report.rows) {
    const double of_row = 1e6 * row.number("slide.seconds/slide.segments").value_or(0);
    if (of_row <= largest || row.number("slide.sum_holes") > 0) continue;
    largest = of_row;
    goal.measured = "at most " + three_digits(of_row) + ", " + row.what;
    goal.reached = of_row <= 3;
  }
  return goal;
}

}  // namespace

std::vector<Goal> goals_of(const Report& report) {
  const double limit = report.setting.limit;
  const auto rows_of = [&](auto is_one) {
    Rows rows = pointers(report.rows);
    std::erase_if(rows, [&](const Row* row) { return !is_one(*row); });
    return rows;
  };
  const auto named = [&](const std::string& name) {
    return rows_of([&](const Row& row) { return row.name == name; });
  };
  const auto beside_cgal = [&](RatioOf ratio_of, const std::string& row) {
    const Rows rows = named(row);
    return rows.empty() ? std::nullopt : ratio_of(*rows[0], "cgal-reduced", "slide", limit);
  };
  const auto as_fast = [&](int goal, const std::string& what, const std::string& row) {
    return at_least(goal,
                    what + ": at least " + std::to_string(goal) +
                        " times as fast as CGAL's reduced convolution",
                    beside_cgal(time_ratio, row));
  };
  const auto little_memory = [&](const std::string& what, const std::string& row) {
    return at_least(10, what + ": at most a tenth of CGAL's memory",
                    beside_cgal(memory_ratio, row));
  };

  std::vector<Ratio> published;
  std::pair<std::optional<Ratio>, std::string> least;
  for (const Row* row : rows_of([](const Row& row) { return row.group == "published"; })) {
    const auto ratio = time_ratio(*row, "cgal-reduced", "slide", limit);
    if (!ratio) continue;
    published.push_back(*ratio);
    if (!least.first || ratio->value < least.first->value) least = {ratio, ", " + row->what};
  }
  Goal least_published = at_least(3, "published pairs: none less than 3 times", least.first);
  least_published.measured += least.second;
  std::optional<Ratio> two_threads;
  for (const Row* row : rows_for(report, Subject::growth))
    if (const auto ratio = time_ratio(*row, "slide", "slide2", limit)) two_threads = ratio;

  return {
      as_fast(50, "stars of 300 and 100", "star_300_star_100"),
      as_fast(25, "stars of 100 and 100", "star_100_star_100"),
      little_memory("stars of 300 and 100", "star_300_star_100"),
      little_memory("stars of 100 and 100", "star_100_star_100"),
      as_fast(25, "simple polygons of 200 and 100", "simple_200_simple_100"),
      as_fast(8, "fork of 50 teeth and L", "fork_50"),
      none_is_faster("fork of 50 teeth and L: no engine is faster", named("fork_50"), limit),
      at_least(8, "published pairs: at least 8 times, geometric mean",
               published.empty() ? std::nullopt : std::optional(geometric_mean(published))),
      least_published,
      as_fast(20, "small pairs", "small_pairs"),
      none_is_faster("no row on which any engine is faster", rows_for(report, Subject::sums),
                     limit),
      time_a_segment(report),
      at_least(1.7, "two threads: at least 1.7 times one, on the largest sum of the growth",
               two_threads),
  };
}

}  // namespace oplus
