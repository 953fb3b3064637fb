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

/// Columns in words, separated by "; ": a heading, " = ", a format and a name. By the name: "what"; a
/// word, but "yes" and "no" for "true" and "false"; what became of an engine ("rca.outcome"); or a
/// number (Row::number) in a format: none, it is whole; "e", a power of ten; else three digits of it
/// times the factor that the format is, so "T_RC, ms = 1000 rca.time". Where an engine has no number,
/// the first column has `instead_of_number`, the others nothing.
std::vector<Column> columns_of(const std::string& words);

/// What stands in a table where there is no number: nothing where the engine was not asked or has none,
/// a dash where it does not take the row, else what became of it.
std::string instead_of_number(const Measurement* measurement);

/// RFC 4180: a line of headers, a line a row, empty cells where nothing was measured. The columns that
/// are named come first, whether any row has them or not; others follow in alphabetical order. What
/// engines found is in columns of their own, "rca_time" and "rca_outcome"; but "m", "sum_holes" and
/// what else is the same for all in one.
std::string to_csv(const Rows& rows, std::vector<std::string> first_columns);

/// The numbers of two names, of the rows that have both.
Points points(const Rows& rows, const std::string& x, const std::string& y);

}  // namespace oplus
