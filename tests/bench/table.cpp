// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/table.hpp"

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>
#include <stdexcept>

#include "tests/bench/numbers.hpp"

namespace oplus {

namespace {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::ostringstream quoted;
  quoted << std::quoted(text, '"', '"');
  return quoted.str();
}

/// The cells of a row by their columns.
std::map<std::string, std::string> csv_cells(const Row& row) {
  const std::set<std::string> of_pair{"m", "n", "questions", "asked", "holes", "others"};
  std::map<std::string, std::string> cells = row.words;
  for (const Measurement& m : row.measurements) {
    cells[m.engine + "_outcome"] = in_words(m);
    if (!m.is_done()) continue;
    for (const auto& [name, value] : m.numbers) {
      const bool is_common = of_pair.contains(name) || name.starts_with("sum_");
      cells[is_common ? name : m.engine + '_' + name] = plain(value);
    }
  }
  for (const auto& [name, value] : row.numbers) cells[name] = plain(value);
  return cells;
}

std::string formatted(const std::string& format, double value) {
  if (format.empty()) return with_thousands(static_cast<std::size_t>(value));
  return format == "e" ? power_of_ten(value) : three_digits(std::stod(format) * value);
}

std::string shown(const Row& row, const std::string& format, const std::string& name,
                  bool says_instead) {
  const std::string engine = name.substr(0, name.find('.'));
  if (name == "what") return row.what;
  if (name.ends_with(".outcome")) return row.of(engine) == nullptr ? "" : in_words(*row.of(engine));
  if (const auto word = row.words.find(name); word != row.words.end())
    return word->second == "true" ? "yes" : word->second == "false" ? "no" : word->second;
  const std::optional<double> value = row.number(name);
  if (value) return formatted(format, *value);
  return says_instead ? instead_of_number(row.of(engine)) : "";
}

}  // namespace

Table table_of(const Rows& rows, const std::vector<Column>& columns) {
  Table table;
  for (const Column& column : columns) table.head.push_back(column.heading);
  for (const Row& row : rows) {
    table.rows.emplace_back();
    for (const Column& column : columns) {
      std::string cell = column.cell(row);
      std::replace(cell.begin(), cell.end(), '|', '/');
      std::replace(cell.begin(), cell.end(), '\n', ' ');
      table.rows.back().push_back(std::move(cell));
    }
  }
  return table;
}

std::vector<Column> columns_of(const std::string& words) {
  std::vector<Column> columns;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find("; ", begin), words.size());
    const std::string column = words.substr(begin, end - begin);
    const std::size_t equals = column.find(" = ");
    if (equals == std::string::npos) throw std::invalid_argument("invalid column: " + column);
    const std::string what = column.substr(equals + 3);
    const std::size_t space = what.find(' ');
    const std::string format = space == std::string::npos ? "" : what.substr(0, space);
    const std::string name = what.substr(space == std::string::npos ? 0 : space + 1);
    columns.push_back({column.substr(0, equals),
                       [=](const Row& row) { return shown(row, format, name, begin == 0); }});
    begin = end + 2;
  }
  return columns;
}

std::string instead_of_number(const Measurement* m) {
  if (m == nullptr || m->is_done()) return "";
  if (m->outcome == Measurement::Ending::unsupported) return "–";
  return m->outcome == Measurement::Ending::failed ? "failed" : in_words(*m);
}

std::string to_csv(const Rows& rows, std::vector<std::string> columns) {
  std::set<std::string> others;
  for (const Row& row : rows)
    for (const auto& [name, cell] : csv_cells(row)) others.insert(name);
  for (const std::string& name : columns) others.erase(name);
  columns.insert(columns.end(), others.begin(), others.end());
  std::string text;
  const auto add_line = [&](auto cell_of) {
    for (const std::string& column : columns)
      text += (column == columns.front() ? "" : ",") + csv_cell(cell_of(column));
    text += '\n';
  };
  add_line([](const std::string& column) { return column; });
  for (const Row& row : rows)
    add_line([cells = csv_cells(row)](const std::string& column) mutable { return cells[column]; });
  return text;
}

Points points(const Rows& rows, const std::string& x, const std::string& y) {
  Points result;
  for (const Row& row : rows) {
    const std::optional<double> of_x = row.number(x);
    const std::optional<double> of_y = row.number(y);
    if (!of_x || !of_y) continue;
    result.x.push_back(*of_x);
    result.y.push_back(*of_y);
  }
  return result;
}

}  // namespace oplus
