// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "properties/experiments/engine_measurement.hpp"
#include "properties/experiments/engine_tables.hpp"
#include "properties/experiments/published_pairs.hpp"

namespace oplus {

namespace {

constexpr const char* missing = "missing";

Row row_of(const PublishedPair& pair, const ExperimentSettings& settings) {
  Row row = is_there(pair) ? measured_engines([&] { return read(pair); }, settings.memory_limit_mb)
                           : Row{{"rca_outcome", missing}, {"winding_outcome", missing}};
  row["name"] = pair.name;
  row["thesis_rca_edges"] = pair.a_rc;
  row["thesis_winding_edges"] = pair.a_w;
  row["thesis_rca_time"] = pair.t_rc;
  row["thesis_winding_time"] = pair.t_w;
  row["thesis_ratio"] = pair.t_rc / pair.t_w;
  if (const std::optional<double> edges = number(row, "rca_edges"))
    row["same_rca_edges"] = *edges == static_cast<double>(pair.a_rc);
  if (const std::optional<double> edges = number(row, "winding_edges"))
    row["same_winding_edges"] = *edges == static_cast<double>(pair.a_w);
  return row;
}

std::size_t count(const Table& table, const std::string& column) {
  std::size_t result = 0;
  for (const Row& row : table.rows) result += row.value(column, false) ? 1 : 0;
  return result;
}

}  // namespace

ExperimentResult run_table_6_1(const ExperimentSettings& settings) {
  ExperimentResult result;
  result.title = "Table 6.1: the published pairs";
  result.table.columns = {"name",
                          "thesis_rca_edges",
                          "thesis_winding_edges",
                          "thesis_rca_time",
                          "thesis_winding_time",
                          "thesis_ratio",
                          "same_rca_edges",
                          "same_winding_edges"};
  for (const std::string& column : engine_columns()) result.table.columns.push_back(column);
  std::size_t skipped = 0;
  for (const PublishedPair& pair : published_pairs()) {
    Row row = row_of(pair, settings);
    if (row.at("rca_outcome") == missing)
      ++skipped;
    else
      add_faults(row, pair.name, result.wrong);
    std::cout << progress_line("table-6.1 " + pair.name, row) << std::endl;
    result.table.rows.push_back(std::move(row));
  }
  result.shown = shown_engine_tables({{"pair", "name"}});
  result.shown.front().columns.insert(result.shown.front().columns.end(),
                                      {{"A_RC as in the thesis", "same_rca_edges"},
                                       {"A_W as in the thesis", "same_winding_edges"},
                                       {"the thesis's T_RC / T_W", "thesis_ratio"}});
  const std::size_t measured = result.table.rows.size() - skipped;
  result.summary = {
      std::to_string(measured) + " pairs measured, " + std::to_string(skipped) +
          " skipped: not in " + published_folder().filename().string() + "/",
      "A_RC is the thesis's in " + std::to_string(count(result.table, "same_rca_edges")) +
          " of them, A_W in " + std::to_string(count(result.table, "same_winding_edges"))};
  return result;
}

}  // namespace oplus
