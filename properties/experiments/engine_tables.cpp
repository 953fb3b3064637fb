// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/engine_tables.hpp"

#include <algorithm>

#include "properties/experiments/engine_measurement.hpp"

namespace oplus {

namespace {

ShownTable stages_of(const std::string& engine, const std::string& called,
                     std::vector<ShownColumn> columns) {
  for (const std::string stage :
       {"cycles", "arrangement", "hierarchy", "hole_test", "degenerate", "output"}) {
    std::string heading = stage;
    std::replace(heading.begin(), heading.end(), '_', ' ');
    columns.push_back({heading, engine + '_' + stage, 1000});
  }
  columns.push_back({"busy", engine + "_busy"});
  columns.push_back({"hole tests", engine + "_hole_tests"});
  columns.push_back({"point tests", engine + "_point_tests"});
  return {"Stages of " + called +
              ", in milliseconds, for how much of that a processor worked on it, and the questions "
              "it asked.",
          columns};
}

}  // namespace

std::vector<ShownTable> shown_engine_tables(const std::vector<ShownColumn>& first) {
  std::vector<ShownColumn> columns = first;
  for (const ShownColumn& column : std::vector<ShownColumn>{
           {"m", "m"},
           {"n", "n"},
           {"holes", "sum_holes"},
           {"A_RC", "rca_edges"},
           {"A_W", "winding_edges"},
           {"T_RC, ms", "rca_time", 1000},
           {"T_W, ms", "winding_time", 1000},
           {"T_RC / T_W", "ratio"},
           {"with output", "ratio_with_output"},
           {"peak RC, MB", "rca_peak_mb"},
           {"peak W, MB", "winding_peak_mb"},
           {"same sum", "same_sum"},
           {"RC", "rca_outcome"},
           {"W", "winding_outcome"},
       })
    columns.push_back(column);
  return {
      {"m and n: vertices of P and Q. RC: `rca`. W: `winding`. A: edges of the arrangement. T: all "
       "stages but the output.",
       columns},
      stages_of("rca", "`rca` (RCA)", first),
      stages_of("winding", "`winding` (CWEIN)", first)};
}

std::vector<std::string> ratio_lines(const Table& table) {
  std::vector<std::string> lines;
  for (const auto& [column, with] :
       {std::pair{"ratio", ""}, {"ratio_with_output", " with output"}}) {
    std::vector<double> ratios;
    for (const Row& row : table.rows)
      if (const std::optional<double> ratio = number(row, column)) ratios.push_back(*ratio);
    if (ratios.empty()) continue;
    const std::string ends =
        shown(ratios.front()) + " at the first row, " + shown(ratios.back()) + " at the last";
    std::sort(ratios.begin(), ratios.end());
    lines.push_back(std::string("T_RC / T_W") + with + ": " + ends + ", median " +
                    shown(ratios[ratios.size() / 2]));
  }
  return lines;
}

void add_faults(const Row& row, const std::string& of_what, std::vector<std::string>& wrong) {
  const std::string fault = fault_of(row);
  if (!fault.empty()) wrong.push_back(of_what + ": " + fault);
}

std::string progress_line(const std::string& of_what, const Row& row) {
  std::string line = of_what + ":";
  for (const std::string engine : {"rca", "winding"}) {
    const std::optional<double> time = number(row, engine + "_time");
    line += ' ' + engine + ' ' +
            (time ? shown(*time) + " s," : row.at(engine + "_outcome").get<std::string>() + ',');
  }
  line.pop_back();
  return line;
}

}  // namespace oplus
