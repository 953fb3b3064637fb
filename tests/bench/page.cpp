// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/page.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

#include "tests/bench/engine.hpp"
#include "tests/bench/goals.hpp"
#include "tests/bench/numbers.hpp"
#include "tests/bench/ratio.hpp"
#include "tests/bench/terminal.hpp"

namespace oplus {

namespace {

using Cells = std::vector<std::string>;

/// A table of Markdown.
class MarkdownTable {
 public:
  explicit MarkdownTable(const Cells& head) : columns_(head.size()) {
    add(head);
    add(Cells(columns_, "---"));
  }

  void add(Cells cells) {
    cells.resize(columns_);
    text_ += '|';
    for (const std::string& cell : cells) text_ += cell == "---" ? "---|" : ' ' + cell + " |";
    text_ += '\n';
  }

  const std::string& text() const { return text_; }

 private:
  std::size_t columns_;
  std::string text_;
};

/// All others are compared with it.
const std::string baseline = "slide";

/// The engines of sums that the run has, in the order in which they are listed.
std::vector<std::string> sum_engines(const Report& report) {
  const std::vector<const RowReport*> of_sums = rows_for(report, Subject::sums);
  std::vector<std::string> names;
  for (const BenchmarkedEngine& engine : benchmarked_engines()) {
    const bool measured = std::any_of(of_sums.begin(), of_sums.end(), [&](const RowReport* row) {
      return row->of(engine.name) != nullptr;
    });
    if (measured && engine.name != "slide2") names.push_back(engine.name);
  }
  return names;
}

std::vector<std::string> others(const Report& report) {
  std::vector<std::string> names = sum_engines(report);
  std::erase(names, baseline);
  return names;
}

/// As it was asked for: "60", "0.25".
std::string plain(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string milliseconds(double seconds) { return three_digits(1000 * seconds); }

/// What stands in a table where there is no number.
std::string instead(const Measurement* m) {
  if (m == nullptr) return "";
  if (m->outcome == Outcome::not_taken) return "–";
  return m->outcome == Outcome::failed ? "failed" : in_words(*m);
}

std::string times(const Report& report) {
  const std::vector<std::string> names = sum_engines(report);
  Cells head{"sum, ms", "segments", "vertices", "holes"};
  head.insert(head.end(), names.begin(), names.end());
  MarkdownTable table(head);
  for (const RowReport* row : rows_for(report, Subject::sums)) {
    const Measurement* exact = agreement_of(*row).exact;
    const Measurement* slide = row->done(baseline);
    Cells cells{row->what,
                slide != nullptr && slide->segments ? with_thousands(*slide->segments) : "",
                exact != nullptr ? with_thousands(exact->vertices) : "",
                exact != nullptr ? with_thousands(exact->holes) : ""};
    for (const std::string& name : names) {
      const Measurement* m = row->done(name);
      cells.push_back(m != nullptr ? milliseconds(m->seconds) : instead(row->of(name)));
    }
    table.add(cells);
  }
  return table.text();
}

std::string evaluated(const Report& report) {
  std::vector<std::string> names = others(report);
  std::erase_if(names, [&](const std::string& name) {
    return std::none_of(report.rows.begin(), report.rows.end(), [&](const RowReport& row) {
      const Measurement* m = row.done(name);
      return m != nullptr && m->seconds_evaluated;
    });
  });
  Cells head{"sum, ms", baseline};
  for (const std::string& name : names) {
    head.push_back(name);
    head.push_back("/ " + baseline);
  }
  MarkdownTable table(head);
  for (const RowReport* row : rows_for(report, Subject::sums)) {
    const Measurement* base = row->done(baseline);
    Cells cells{row->what, base != nullptr ? milliseconds(base->seconds) : ""};
    for (const std::string& name : names) {
      const Measurement* m = row->done(name);
      const bool known = m != nullptr && m->seconds_evaluated;
      cells.push_back(known ? milliseconds(*m->seconds_evaluated) : instead(row->of(name)));
      cells.push_back(known && base != nullptr ? three_digits(*m->seconds_evaluated / base->seconds)
                                               : "");
    }
    table.add(cells);
  }
  return table.text();
}

using RatioOf = std::optional<Ratio>(const Report& report, const RowReport& row,
                                     const std::string& engine, const std::string& base);

/// The geometric means of a group, where it has several rows; a row without a ratio is left out.
void add_means(const Report& report, const std::vector<const RowReport*>& group, RatioOf ratio_of,
               Cells cells, MarkdownTable& table) {
  if (group.size() < 2) return;
  for (const std::string& name : others(report)) {
    std::vector<Ratio> ratios;
    for (const RowReport* row : group)
      if (const auto ratio = ratio_of(report, *row, name, baseline)) ratios.push_back(*ratio);
    cells.push_back(ratios.empty() ? "" : '*' + ratio_text(geometric_mean(ratios)) + '*');
  }
  table.add(cells);
}

std::string ratios(const Report& report, const Cells& first_heads, RatioOf ratio_of,
                   const std::function<Cells(const RowReport&)>& first_cells) {
  Cells head = first_heads;
  for (const std::string& name : others(report)) head.push_back(name);
  MarkdownTable table(head);
  const std::vector<const RowReport*> of_sums = rows_for(report, Subject::sums);
  std::vector<const RowReport*> group;
  for (std::size_t i = 0; i < of_sums.size(); ++i) {
    const RowReport& row = *of_sums[i];
    Cells cells = first_cells(row);
    for (const std::string& name : others(report)) {
      const std::optional<Ratio> ratio = ratio_of(report, row, name, baseline);
      cells.push_back(ratio ? ratio_text(*ratio) : instead(row.of(name)));
    }
    table.add(cells);
    group.push_back(&row);
    if (i + 1 == of_sums.size() || of_sums[i + 1]->group != row.group) {
      Cells mean(first_heads.size());
      mean[0] = "*" + row.group + ", geometric mean*";
      add_means(report, group, ratio_of, mean, table);
      group.clear();
    }
  }
  return table.text();
}

std::string time_ratios(const Report& report) {
  return ratios(report, {"time / " + baseline}, time_ratio,
                [](const RowReport& row) { return Cells{row.what}; });
}

std::string memory_ratios(const Report& report) {
  return ratios(report, {"memory / " + baseline, baseline + ", MB"}, memory_ratio,
                [](const RowReport& row) {
                  const Measurement* base = row.done(baseline);
                  return Cells{row.what, base != nullptr ? three_digits(base->peak_mb) : ""};
                });
}

std::string throughput(const Report& report) {
  MarkdownTable table({"engine", "pairs a second", "with coordinates evaluated"});
  std::string what;
  for (const RowReport* row : rows_for(report, Subject::sums)) {
    if (row->pairs == 1) continue;
    for (const std::string& name : sum_engines(report)) {
      const Measurement* m = row->done(name);
      const double pairs = static_cast<double>(row->pairs);
      table.add({name, m != nullptr ? three_digits(pairs / m->seconds) : instead(row->of(name)),
                 m != nullptr && m->seconds_evaluated ? three_digits(pairs / *m->seconds_evaluated)
                                                      : ""});
    }
  }
  return table.text();
}

std::string errors(const Report& report) {
  std::vector<std::string> names;
  for (const std::string& name : others(report))
    if (find_benchmarked_engine(name)->arithmetic == Arithmetic::rounding) names.push_back(name);
  Cells head{"sum", "holes"};
  for (const std::string& name : names) {
    head.push_back(name + ": area off by");
    head.push_back("relative");
    head.push_back("holes");
  }
  MarkdownTable table(head);
  for (const RowReport* row : rows_for(report, Subject::sums)) {
    const Measurement* exact = agreement_of(*row).exact;
    Cells cells{row->what, exact != nullptr ? with_thousands(exact->holes) : "unknown"};
    for (const std::string& name : names) {
      const Measurement* m = row->done(name);
      const bool known = m != nullptr && exact != nullptr;
      cells.push_back(known ? power_of_ten(absolute_area_error(*m, *exact))
                            : instead(row->of(name)));
      cells.push_back(known ? power_of_ten(relative_area_error(*m, *exact)) : "");
      cells.push_back(m != nullptr ? with_thousands(m->holes) : "");
    }
    table.add(cells);
  }
  return table.text();
}

std::string growth(const Report& report) {
  MarkdownTable table({"sum", "segments", "slide, ms", "µs a segment", "MB"});
  for (const RowReport* row : rows_for(report, Subject::growth)) {
    const Measurement* m = row->done("slide");
    if (m == nullptr || !m->segments) continue;
    table.add({row->what, with_thousands(*m->segments), milliseconds(m->seconds),
               three_digits(1e6 * m->seconds / static_cast<double>(*m->segments)),
               three_digits(m->peak_mb)});
  }
  return table.text();
}

std::string threads(const Report& report) {
  MarkdownTable table({"sum", "one thread, ms", "two threads, ms", "one / two"});
  for (const RowReport& row : report.rows) {
    const Measurement* one = row.done("slide");
    const Measurement* two = row.done("slide2");
    if (one == nullptr || two == nullptr) continue;
    table.add({row.what, milliseconds(one->seconds), milliseconds(two->seconds),
               three_digits(one->seconds / two->seconds)});
  }
  return table.text();
}

std::string convolutions(const Report& report) {
  MarkdownTable table(
      {"convolution of", "traced, ms", "naive, ms", "naive / traced", "steps", "segments"});
  for (const RowReport* row : rows_for(report, Subject::convolution)) {
    const Measurement* traced = row->done("traced");
    const Measurement* naive = row->done("naive");
    if (traced == nullptr || naive == nullptr) continue;
    table.add({row->what, milliseconds(traced->seconds), milliseconds(naive->seconds),
               three_digits(naive->seconds / traced->seconds),
               with_thousands(traced->steps.value_or(0)),
               with_thousands(traced->segments.value_or(0))});
  }
  return table.text();
}

/// What is not a number in the tables, and why.
std::string remarks(const Report& report) {
  std::string text;
  for (const RowReport& row : report.rows) {
    const std::string disagreement = agreement_of(row).disagreement;
    if (!disagreement.empty()) text += "- " + row.what + ": **" + disagreement + " disagree**.\n";
    for (const Measurement& m : row.measurements)
      if (m.outcome != Outcome::done && m.outcome != Outcome::over_limit)
        text += "- " + row.what + ": " + m.engine + ' ' + in_words(m) + ".\n";
  }
  for (const std::string& name : report.setting.missing)
    text += "- The published pair " + name + " was not there.\n";
  return text.empty() ? "- Every engine took every row.\n" : text;
}

/// How much others were in the way.
std::string busy(const Report& report) {
  std::size_t measured = 0;
  std::size_t well = 0;
  for (const RowReport& row : report.rows) {
    for (const Measurement& m : row.measurements) {
      if (m.outcome != Outcome::done) continue;
      ++measured;
      if (m.busy >= 0.95) ++well;
    }
  }
  return std::to_string(well) + " of " + std::to_string(measured);
}

std::string agreement(const Report& report) {
  std::size_t compared = 0;
  std::size_t equal = 0;
  for (const RowReport& row : report.rows) {
    std::size_t exact = 0;
    for (const Measurement& m : row.measurements)
      if (m.outcome == Outcome::done && find_benchmarked_engine(m.engine) != nullptr &&
          find_benchmarked_engine(m.engine)->arithmetic == Arithmetic::exact)
        ++exact;
    if (exact < 2) continue;
    ++compared;
    if (agreement_of(row).disagreement.empty()) ++equal;
  }
  return "On " + std::to_string(equal) + " of " + std::to_string(compared) +
         " rows with two exact engines or more, all exact results are equal";
}

std::string goals(const Report& report) {
  MarkdownTable table({"goal", "measured", "reached"});
  for (const Goal& goal : goals_of(report))
    table.add({goal.text, goal.measured,
               !goal.reached   ? "not measured"
               : *goal.reached ? "yes"
                               : "**no**"});
  return table.text();
}

std::string engine_list(const Report& report) {
  std::string text;
  for (const std::string& name : sum_engines(report))
    text += "- `" + name + "`: " + find_benchmarked_engine(name)->what + ".\n";
  return text;
}

}  // namespace

std::string page_of(const Report& report, const std::string& page_template) {
  const Setting& setting = report.setting;
  const std::map<std::string, std::string> marks{
      {"ENGINES", engine_list(report)},
      {"MACHINE", setting.processor + ", " + std::to_string(setting.cores) + " cores"},
      {"COMPILER", setting.compiler},
      {"LIBRARIES", setting.libraries},
      {"COMMAND", setting.command},
      {"LIMIT", plain(setting.limit)},
      {"AGREEMENT", agreement(report)},
      {"BUSY", busy(report)},
      {"TIMES", times(report)},
      {"GOALS", goals(report)},
      {"RATIOS", time_ratios(report)},
      {"EVALUATED", evaluated(report)},
      {"THROUGHPUT", throughput(report)},
      {"MEMORY", memory_ratios(report)},
      {"ERRORS", errors(report)},
      {"GROWTH", growth(report)},
      {"THREADS", threads(report)},
      {"CONVOLUTIONS", convolutions(report)},
      {"REMARKS", remarks(report)},
  };
  std::string page;
  for (std::size_t at = 0; at < page_template.size();) {
    const std::size_t open = page_template.find('@', at);
    page += page_template.substr(at, open - at);
    if (open == std::string::npos) break;
    const std::size_t close = page_template.find('@', open + 1);
    if (close == std::string::npos) throw std::invalid_argument("a mark has no end");
    const std::string name = page_template.substr(open + 1, close - open - 1);
    const auto mark = marks.find(name);
    if (mark == marks.end()) throw std::invalid_argument("unknown mark @" + name + "@");
    page += mark->second;
    at = close + 1;
  }
  return page;
}

}  // namespace oplus
