// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/page.hpp"

#include <algorithm>

#include "tests/bench/engine.hpp"
#include "tests/bench/goals.hpp"
#include "tests/bench/measuring.hpp"
#include "tests/bench/numbers.hpp"

namespace oplus {

namespace {

/// The engines of sums that the run has, in the order in which they are listed.
std::vector<std::string> sum_engines(const Rows& rows) {
  std::vector<std::string> names;
  for (const BenchEngine& engine : bench_engines())
    if (engine.name != "slide2" && std::any_of(rows.begin(), rows.end(), [&](const Row* row) {
          return row->of(engine.name) != nullptr;
        }))
      names.push_back(engine.name);
  return names;
}

/// All are compared with slide.
std::vector<std::string> others(const Rows& rows) {
  std::vector<std::string> names = sum_engines(rows);
  std::erase(names, "slide");
  return names;
}

/// A row for each row, and one for the geometric means of a group that has several; where there is no
/// ratio the row is left out of them.
Table ratios(const Rows& rows, double limit, const std::string& first, RatioOf ratio_of) {
  std::vector<Column> columns = columns_of(first);
  const std::size_t first_columns = columns.size();
  for (const std::string& name : others(rows))
    columns.push_back({name, [=](const Row& row) {
                         const std::optional<Ratio> ratio = ratio_of(row, name, "slide", limit);
                         return ratio ? ratio_text(*ratio) : instead_of_number(row.of(name));
                       }});
  Table table = table_of({}, columns);
  for (auto begin = rows.begin(), end = begin; begin != rows.end(); begin = end) {
    const std::string name_of_group = (*begin)->group;
    end = std::find_if(begin, rows.end(),
                       [&](const Row* row) { return row->group != name_of_group; });
    const Rows group(begin, end);
    const Table of_group = table_of(group, columns);
    table.rows.insert(table.rows.end(), of_group.rows.begin(), of_group.rows.end());
    if (group.size() < 2) continue;
    std::vector<std::string> means(first_columns);
    means[0] = "*" + name_of_group + ", geometric mean*";
    for (const std::string& name : others(rows)) {
      std::vector<Ratio> found;
      for (const Row* row : group)
        if (const auto ratio = ratio_of(*row, name, "slide", limit)) found.push_back(*ratio);
      means.push_back(found.empty() ? "" : '*' + ratio_text(geometric_mean(found)) + '*');
    }
    table.rows.push_back(means);
  }
  return table;
}

Table throughput(const Rows& rows) {
  Table table{{"engine", "pairs a second", "with coordinates evaluated"}, {}};
  for (const Row* row : rows) {
    if (row->pairs == 1) continue;
    const auto rate = [&](const std::optional<double>& seconds) {
      return seconds ? three_digits(static_cast<double>(row->pairs) / *seconds) : "";
    };
    for (const std::string& name : sum_engines(rows)) {
      const Measurement* m = row->done(name);
      table.rows.push_back(
          {name, m == nullptr ? instead_of_number(row->of(name)) : rate(m->number("seconds")),
           rate(row->number(name + ".seconds_evaluated"))});
    }
  }
  return table;
}

/// Those on which these engines got to the end.
Rows where_done(Rows rows, const std::vector<std::string>& engines) {
  std::erase_if(rows, [&](const Row* row) {
    return std::any_of(engines.begin(), engines.end(),
                       [&](const std::string& name) { return row->done(name) == nullptr; });
  });
  return rows;
}

/// What is not a number in the tables, and why.
std::vector<std::string> remarks(const Report& report) {
  std::vector<std::string> found;
  for (const Row& row : report.rows) {
    const std::string disagreement = agreement_of(row).disagreement;
    if (!disagreement.empty()) found.push_back(row.what + ": **" + disagreement + " disagree**");
    for (const Measurement& m : row.measurements)
      if (!m.is_done() && m.outcome != Measurement::Outcome::over_limit)
        found.push_back(row.what + ": " + m.engine + ' ' + in_words(m));
  }
  for (const std::string& name : report.setting.missing)
    found.push_back("The published pair " + name + " was not there");
  return found;
}

Table goals(const Report& report) {
  Table table{{"goal", "measured", "reached"}, {}};
  for (const Goal& goal : goals_of(report))
    table.rows.push_back({goal.text, goal.measured,
                          !goal.reached   ? "not measured"
                          : *goal.reached ? "yes"
                                          : "**no**"});
  return table;
}

PageData engine_list(const Rows& rows) {
  PageData list(PageData::type::list);
  for (const std::string& name : sum_engines(rows)) {
    PageData engine("name", name);
    engine.set("what", find_bench_engine(Subject::sums, name)->what);
    list << engine;
  }
  return list;
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
  const Setting& setting = report.setting;
  PageData data("processor", setting.processor);
  data.set("cores", std::to_string(setting.cores));
  data.set("compiler", setting.compiler);
  data.set("libraries", setting.libraries);
  data.set("commit", setting.commit);
  data.set("command", setting.command);
  data.set("limit", plain(setting.limit));
  data.set("repetitions", std::to_string(repetitions));
  data.set("busy", std::to_string(busy));
  data.set("measured", std::to_string(measured));
  data.set("equal", std::to_string(equal));
  data.set("compared", std::to_string(compared));
  data.set("remarks", page_data(remarks(report)));

  const Rows all = pointers(report.rows);
  const Rows sums = rows_for(report, Subject::sums);
  std::vector<std::string> lazy = others(sums);
  std::erase_if(lazy, [&](const std::string& name) {
    const std::string evaluated = name + ".seconds_evaluated";
    return points(sums, evaluated, evaluated).x.empty();
  });
  std::vector<std::string> rounding = others(sums);
  std::erase_if(rounding, [](const std::string& name) {
    return !find_bench_engine(Subject::sums, name)->rounds;
  });
  data.set("engines", engine_list(sums));
  data.set("sums", table_section(sums, sum_engines(sums)));
  data.set("lazy_engines", table_section(sums, lazy));
  data.set("rounding_engines", table_section(sums, rounding));
  data.set("growth", table_section(where_done(rows_for(report, Subject::growth), {"slide"})));
  data.set("threads", table_section(where_done(all, {"slide", "slide2"})));
  data.set("convolutions", table_section(where_done(all, {"traced", "naive"})));

  const double limit = report.setting.limit;
  data.set("goals", page_data(goals(report)));
  data.set("throughput", page_data(throughput(sums)));
  data.set("ratios", page_data(ratios(sums, limit, "time / slide = what", time_ratio)));
  data.set("memory",
           page_data(ratios(sums, limit, "memory / slide = what; slide, MB = 1 slide.peak_mb",
                            memory_ratio)));
  return data;
}

}  // namespace oplus
