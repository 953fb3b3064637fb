// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace oplus {

/// A row by the names of its columns: strings, numbers and booleans. What was not measured is absent.
using Row = nlohmann::json;

struct Table {
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// A column as readers of a page see it.
struct ShownColumn {
  std::string heading;
  std::string column;
  double factor = 1;  ///< 1000 shows seconds as milliseconds
};

/// The number in a cell, if there is one.
std::optional<double> number(const Row& row, const std::string& column);

/// The numbers of two columns, of the rows that have both.
struct Points {
  std::vector<double> x;
  std::vector<double> y;
};
Points points(const Table& table, const std::string& x, const std::string& y);

/// Three significant digits, no exponent.
std::string shown(double value);

/// RFC 4180: a line of headers, a line a row, empty cells where nothing was measured.
std::string to_csv(const Table& table);

/// Whole numbers exactly, other numbers as `shown`, a dash where nothing was measured.
std::string to_markdown(const Table& table, const std::vector<ShownColumn>& columns);

}  // namespace oplus
