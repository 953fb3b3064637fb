// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/fit.hpp"
#include "tests/bench/row.hpp"

namespace oplus {

/// A table of a page.
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

struct Column {
  std::string heading;
  std::function<std::string(const Row&)> cell;
};

Table table_of(const Rows& rows, const std::vector<Column>& columns);

/// Columns described by text, separated by "; ": a heading, " = ", a format and a name, such as
/// "T_RC, ms = 1000 rca.time". The name is "what"; a word of the row ("true" and "false" are shown as
/// "yes" and "no"); an outcome ("rca.outcome"); or a number (Row::number). The format of a number is
/// empty for an integer, "e" for a power of ten, otherwise a factor, and three digits of the product
/// are shown. If an engine has no number, the first column has `instead_of_number`, others are empty.
std::vector<Column> columns_of(const std::string& words);

/// The cell of a missing number: empty if the engine was not measured or has no such number, a dash if
/// the row is unsupported, otherwise the outcome.
std::string instead_of_number(const Measurement* measurement);

/// RFC 4180: a line of headers, a line per row, empty cells where nothing was measured. First come the
/// named columns, even if empty; others follow in alphabetical order. Each engine has its own columns,
/// "rca_time" and "rca_outcome"; numbers that are the same for all, such as "m" and "sum_holes", have one.
std::string to_csv(const Rows& rows, std::vector<std::string> first_columns);

/// The numbers x and y of the rows that have both.
Points points(const Rows& rows, const std::string& x, const std::string& y);

}  // namespace oplus
