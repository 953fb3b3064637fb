// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "tests/bench/numbers.hpp"
#include "tests/bench/page.hpp"

namespace oplus {

namespace {

using Goal = std::vector<std::string>;  ///< a row of the table

Goal goal(const std::string& text, const std::string& measured, std::optional<bool> reached) {
  return {text, measured, !reached ? "not measured" : *reached ? "yes" : "**no**"};
}

/// A ratio that should be large, and its row. A lower bound below the goal decides nothing.
Goal at_least(double least, const std::string& text, const std::optional<Ratio>& ratio,
              const std::string& row = "") {
  if (!ratio) return goal(text, "", std::nullopt);
  const bool is_unknown = ratio->is_lower_bound && ratio->value < least;
  return goal(text, ratio_text(*ratio) + (row.empty() ? "" : ", " + row),
              is_unknown ? std::nullopt : std::optional(ratio->value >= least));
}

/// The rows on which another engine takes less time than slide.
Goal none_is_faster(const std::string& text, const Rows& rows, double limit) {
  std::string faster;
  bool measured = false;
  for (const Row& row : rows) {
    for (const Measurement& m : row.measurements) {
      const auto of_m = ratio(row, "seconds", m.engine, "slide", limit);
      if (m.engine.starts_with("slide") || !of_m) continue;
      measured = true;
      if (!of_m->is_lower_bound && of_m->value < 1)
        faster += (faster.empty() ? "" : "; ") + row.what + ": " + m.engine + ", " +
                  three_digits(of_m->value);
    }
  }
  if (!measured) return goal(text, "", std::nullopt);
  return goal(text, faster.empty() ? "none" : faster, faster.empty());
}

/// The largest quotient of the times of an engine and of `base`, after `spare` seconds are taken off. One
/// that was stopped may be larger.
Goal at_most(double most, const std::string& text, const Rows& rows, double limit,
             const std::string& engine, double spare = 0, const std::string& base = "slide") {
  double largest = -1;
  bool any_stopped = false;
  std::string measured;
  for (const Row& row : rows) {
    const std::optional<Ratio> of_row = ratio(row, "seconds", engine, base, limit);
    if (!of_row) continue;
    any_stopped = any_stopped || of_row->is_lower_bound;
    const double value = std::max(of_row->value - spare / *row.number(base + ".seconds"), 0.0);
    if (value <= largest) continue;
    largest = value;
    measured = (of_row->is_lower_bound ? "" : "at most ") +
               ratio_text({value, of_row->is_lower_bound}) + ", " + row.what;
  }
  if (measured.empty() || (largest <= most && any_stopped))
    return goal(text, measured, std::nullopt);
  return goal(text, measured, largest <= most);
}

/// The largest quotient of a number, multiplied by a factor, and the size of the reduced convolution.
Goal per_segment(const std::string& text, const Rows& rows, const std::string& number,
                 double factor, double most) {
  double largest = 0;
  std::string measured;
  for (const Row& row : rows) {
    const double of_row = factor * row.number(number + "/slide.segments").value_or(0);
    if (of_row <= largest) continue;
    largest = of_row;
    measured = "at most " + three_digits(of_row) + ", " + row.what;
  }
  return goal(text, measured, measured.empty() ? std::nullopt : std::optional(largest <= most));
}

/// The least ratio of an engine's time to that of `base`, and its row.
std::pair<std::optional<Ratio>, std::string> least_ratio(const Rows& rows, double limit,
                                                         const std::string& engine,
                                                         const std::string& base) {
  std::pair<std::optional<Ratio>, std::string> least;
  for (const Row& row : rows)
    if (const auto of_row = ratio(row, "seconds", engine, base, limit))
      if (!least.first || of_row->value < least.first->value) least = {of_row, row.what};
  return least;
}

}  // namespace

Table goals_of(const Report& report) {
  const double limit = report.setting.limit;
  const auto named = [&](const std::string& name) {
    return rows_where(report.rows, [&](const Row& row) { return row.name == name; });
  };
  const auto beside_cgal = [&](const std::string& number, const std::string& name) {
    const Rows rows = named(name);
    return rows.empty() ? std::nullopt : ratio(rows[0], number, "cgal-reduced", "slide", limit);
  };
  const auto as_fast = [&](int least, const std::string& what, const std::string& row) {
    return at_least(least,
                    what + ": at least " + std::to_string(least) +
                        " times as fast as CGAL's reduced convolution",
                    beside_cgal("seconds", row));
  };
  const auto little_memory = [&](const std::string& what, const std::string& row) {
    return at_least(10, what + ": at most a tenth of CGAL's memory", beside_cgal("peak_mb", row));
  };

  const auto grouped = [&](const std::string& name) {
    return rows_where(report.rows, [&](const Row& row) { return row.group == name; });
  };
  std::vector<Ratio> published;
  for (const Row& row : grouped("published"))
    if (const auto of_row = ratio(row, "seconds", "cgal-reduced", "slide", limit))
      published.push_back(*of_row);
  const auto least = least_ratio(grouped("published"), limit, "cgal-reduced", "slide");
  const Rows with_certificates = rows_for(report.rows, Subject::certificates);
  Rows checked = grouped("certificates");
  const auto is_checked = [](const Row& row) { return row.done("oplus-certified") != nullptr; };
  if (!std::ranges::all_of(checked, is_checked)) checked.clear();
  const auto checking = least_ratio(checked, limit, "cgal-sum", "oplus-certified");
  std::optional<Ratio> small_pairs_a_second;
  for (const Row& row : named("command_small_pairs"))
    if (const auto seconds = row.number("oplus-batch.seconds"))
      small_pairs_a_second = Ratio{static_cast<double>(row.pairs) / *seconds, false};
  std::optional<Ratio> two_threads;
  for (const Row& row : rows_for(report.rows, Subject::growth))
    if (const auto of_row = ratio(row, "seconds", "slide", "slide2", limit)) two_threads = of_row;

  return {
      {"goal", "measured", "reached"},
      {
          as_fast(50, "stars of 300 and 100", "star_300_star_100"),
          as_fast(25, "stars of 100 and 100", "star_100_star_100"),
          little_memory("stars of 300 and 100", "star_300_star_100"),
          little_memory("stars of 100 and 100", "star_100_star_100"),
          as_fast(25, "simple polygons of 200 and 100", "simple_200_simple_100"),
          as_fast(8, "fork of 50 teeth and L", "fork_50"),
          none_is_faster("fork of 50 teeth and L: no engine is faster", named("fork_50"), limit),
          at_least(10, "published pairs: at least 10 times, geometric mean",
                   published.empty() ? std::nullopt : std::optional(geometric_mean(published))),
          at_least(3, "published pairs: none less than 3 times", least.first, least.second),
          as_fast(10, "small pairs", "small_pairs"),
          none_is_faster("no row on which another engine is faster",
                         rows_for(report.rows, Subject::sums), limit),
          per_segment("sums without holes: at most 3 µs per segment of the reduced convolution",
                      rows_where(report.rows,
                                 [](const Row& row) {
                                   return row.group != "hard" &&
                                          row.number("slide.sum_holes").value_or(0) == 0;
                                 }),
                      "slide.seconds", 1e6, 3),
          per_segment("hard pairs: at most 10 µs per segment of the reduced convolution",
                      grouped("hard"), "slide.seconds", 1e6, 10),
          at_most(1.3, "whole command: at most 1.3 times the call, and 10 ms",
                  rows_for(report.rows, Subject::commands), limit, "oplus-sum", 0.01),
          at_least(20'000, "small pairs, the whole command `oplus batch`: at least 20,000 a second",
                   small_pairs_a_second),
          at_most(2, "open sums: at most twice the time of closed ones",
                  rows_for(report.rows, Subject::sums), limit, "slide-open"),
          at_most(20, "verify: at most 20 times the time of slide",
                  rows_for(report.rows, Subject::sums), limit, "verify"),
          at_least(1.8, "two threads: at least 1.8 times one, on the largest sum of the growth",
                   two_threads),
          at_least(1, "certificates: checked at least as fast as CGAL's program sums",
                   checking.first, checking.second),
          at_most(10, "certificates: made in at most 10 times `oplus sum`, and 0.1 s",
                  with_certificates, limit, "sum-certificate", 0.1, "oplus-sum"),
          per_segment(
              "certificates: at most 200 bytes by gzip per segment of the reduced convolution",
              with_certificates, "sum-certificate.zipped_bytes", 1, 200),
      }};
}

}  // namespace oplus
