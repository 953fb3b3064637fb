// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/page.hpp"

#include <algorithm>

#include "tests/bench/engine.hpp"
#include "tests/bench/measuring.hpp"
#include "tests/bench/numbers.hpp"

namespace oplus {

namespace {

using Names = std::vector<std::string>;

/// The engines of sums in the run, in the order of bench_engines().
Names sum_engines(const Rows& rows) {
  Names names;
  for (const BenchEngine& engine : bench_engines())
    if (engine.name != "slide2" && engine.is_of_all_rows &&
        std::ranges::any_of(rows, [&](const Row& row) { return row.of(engine.name); }))
      names.push_back(engine.name);
  return names;
}

/// A line per row, and one of geometric means per group of several rows; rows without a ratio to slide do
/// not count for the means.
Table ratios(const Rows& rows, const Names& engines, double limit, const std::string& first,
             const std::string& number) {
  const auto ratio_of = [=](const Row& row, const std::string& engine) {
    return ratio(row, number, engine, "slide", limit);
  };
  std::vector<Column> columns = columns_of(first);
  const std::size_t first_columns = columns.size();
  for (const std::string& name : engines)
    columns.push_back({name, [=](const Row& row) {
                         const std::optional<Ratio> found = ratio_of(row, name);
                         return found ? ratio_text(*found) : instead_of_number(row.of(name));
                       }});
  Table table = table_of({}, columns);
  for (auto begin = rows.begin(), end = begin; begin != rows.end(); begin = end) {
    end =
        std::find_if(begin, rows.end(), [&](const Row& row) { return row.group != begin->group; });
    const Rows group(begin, end);
    const Table of_group = table_of(group, columns);
    table.rows.insert(table.rows.end(), of_group.rows.begin(), of_group.rows.end());
    if (group.size() < 2) continue;
    Names means(first_columns);
    means[0] = "*" + begin->group + ", geometric mean*";
    for (const std::string& name : engines) {
      std::vector<Ratio> found;
      for (const Row& row : group)
        if (const auto of_row = ratio_of(row, name)) found.push_back(*of_row);
      means.push_back(found.empty() ? "" : '*' + ratio_text(geometric_mean(found)) + '*');
    }
    table.rows.push_back(means);
  }
  return table;
}

Table throughput(const Rows& rows) {
  Table table{{"engine", "pairs per second", "with coordinates evaluated"}, {}};
  for (const Row& row : rows) {
    if (row.pairs == 1) continue;
    const auto rate = [&](const std::optional<double>& seconds) {
      return seconds ? three_digits(static_cast<double>(row.pairs) / *seconds) : "";
    };
    for (const std::string& name : sum_engines(rows)) {
      const Measurement* m = row.done(name);
      table.rows.push_back(
          {name, m == nullptr ? instead_of_number(row.of(name)) : rate(m->number("seconds")),
           rate(row.number(name + ".seconds_evaluated"))});
    }
  }
  return table;
}

/// The rows on which these engines are done.
Rows where_done(const Rows& rows, const Names& engines) {
  return rows_where(rows, [&](const Row& row) {
    return std::ranges::all_of(engines, [&](const std::string& name) { return row.done(name); });
  });
}

/// The cells of the tables that are not numbers, with the reasons.
Names remarks(const Report& report) {
  Names found;
  for (const Row& row : report.rows) {
    const std::string disagreement = agreement_of(row).disagreement;
    if (!disagreement.empty()) found.push_back(row.what + ": **" + disagreement + " disagree**");
    for (const Measurement& m : row.measurements)
      if (!m.is_done() && m.outcome != Measurement::Ending::over_limit)
        found.push_back(row.what + ": " + m.engine + ' ' + in_words(m));
  }
  for (const std::string& name : report.setting.missing)
    found.push_back("The published pair " + name + " is missing");
  return found;
}

}  // namespace

PageData benchmarks_data(const Report& report) {
  std::size_t measured = 0;
  std::size_t busy = 0;
  std::size_t compared = 0;
  std::size_t equal = 0;
  for (const Row& row : report.rows) {
    for (const Measurement& m : row.measurements) {
      if (m.is_done()) ++measured;
      if (m.is_done() && m.number("busy") >= 0.95) ++busy;
    }
    const Agreement agreement = agreement_of(row);
    if (agreement.compared < 2) continue;
    ++compared;
    if (agreement.disagreement.empty()) ++equal;
  }

  const Rows sums = rows_for(report.rows, Subject::sums);
  const Names engines = sum_engines(sums);
  Names others = engines;
  std::erase(others, "slide");
  kainjow::mustache::list listed;
  Names lazy;
  Names rounding;
  for (const std::string& name : engines)
    listed.push_back(kainjow::mustache::object{
        {"name", name}, {"what", find_bench_engine(Subject::sums, name)->what}});
  for (const std::string& name : others) {
    const std::string evaluated = name + ".seconds_evaluated";
    if (!points(sums, evaluated, evaluated).x.empty()) lazy.push_back(name);
    if (find_bench_engine(Subject::sums, name)->rounds) rounding.push_back(name);
  }

  const Setting& setting = report.setting;
  return kainjow::mustache::object{
      {"processor", setting.processor},
      {"cores", std::to_string(setting.cores)},
      {"compiler", setting.compiler},
      {"libraries", setting.libraries},
      {"commit", setting.commit},
      {"command", setting.command},
      {"limit", plain(setting.limit)},
      {"repetitions", std::to_string(repetitions)},
      {"busy", std::to_string(busy)},
      {"measured", std::to_string(measured)},
      {"equal", std::to_string(equal)},
      {"compared", std::to_string(compared)},
      {"remarks", page_data(remarks(report))},
      {"engines", listed},
      {"sums", table_section(sums, engines)},
      {"lazy_engines", table_section(sums, lazy)},
      {"rounding_engines", table_section(sums, rounding)},
      {"growth", table_section(where_done(rows_for(report.rows, Subject::growth), {"slide"}))},
      {"commands", table_section(rows_for(report.rows, Subject::commands))},
      {"certificates", table_section(rows_for(report.rows, Subject::certificates))},
      {"threads", table_section(where_done(report.rows, {"slide", "slide2"}))},
      {"convolutions", table_section(where_done(report.rows, {"traced", "naive"}))},
      {"goals", page_data(goals_of(report))},
      {"throughput", page_data(throughput(sums))},
      {"ratios", page_data(ratios(sums, others, setting.limit, "time / slide = what", "seconds"))},
      {"memory",
       page_data(ratios(sums, others, setting.limit,
                        "memory / slide = what; slide, MB = 1 slide.peak_mb", "peak_mb"))}};
}

}  // namespace oplus
