// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace oplus {

namespace {

const Row* cell(const Row& row, const std::string& column) {
  const auto found = row.find(column);
  return found == row.end() || found->is_null() ? nullptr : &*found;
}

/// Not by a stream: a locale must not change what a table says.
std::string written(double value, std::chars_format format, int precision) {
  std::array<char, 512> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr;
  return {text.data(), end};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result.append(c == '"' ? 2 : 1, c);
  return result + '"';
}

std::string csv_cell(const Row* cell) {
  if (cell == nullptr) return "";
  if (cell->is_string()) return quoted(cell->get<std::string>());
  if (cell->is_number_float()) return written(cell->get<double>(), std::chars_format::general, 6);
  return cell->dump();
}

std::string markdown_cell(const Row* cell, double factor) {
  if (cell == nullptr) return "–";
  if (cell->is_boolean()) return cell->get<bool>() ? "yes" : "no";
  if (cell->is_number_float()) return shown(cell->get<double>() * factor);
  if (!cell->is_string()) return cell->dump();
  std::string text = cell->get<std::string>();
  std::replace(text.begin(), text.end(), '|', '/');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::optional<double> number(const Row& row, const std::string& column) {
  const Row* found = cell(row, column);
  if (found == nullptr || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

Points points(const Table& table, const std::string& x, const std::string& y) {
  Points result;
  for (const Row& row : table.rows) {
    const std::optional<double> of_x = number(row, x);
    const std::optional<double> of_y = number(row, y);
    if (!of_x || !of_y) continue;
    result.x.push_back(*of_x);
    result.y.push_back(*of_y);
  }
  return result;
}

std::string shown(double value) {
  if (value == 0) return "0";
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return written(value, std::chars_format::fixed, std::max(0, 2 - magnitude));
}

std::string to_csv(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    text += (i == 0 ? "" : ",") + quoted(table.columns[i]);
  text += '\n';
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      text += (i == 0 ? "" : ",") + csv_cell(cell(row, table.columns[i]));
    text += '\n';
  }
  return text;
}

std::string to_markdown(const Table& table, const std::vector<ShownColumn>& columns) {
  std::string text = "|";
  for (const ShownColumn& column : columns) text += ' ' + column.heading + " |";
  text += "\n|";
  for (std::size_t i = 0; i < columns.size(); ++i) text += "---|";
  text += '\n';
  for (const Row& row : table.rows) {
    text += '|';
    for (const ShownColumn& column : columns)
      text += ' ' + markdown_cell(cell(row, column.column), column.factor) + " |";
    text += '\n';
  }
  return text;
}

}  // namespace oplus
