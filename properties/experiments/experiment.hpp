// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "properties/experiments/table.hpp"

namespace oplus {

struct ExperimentSettings {
  std::uint64_t seed = 1;
  double scale = 1;                    ///< of the largest size of each family
  std::size_t memory_limit_mb = 8000;  ///< of one measurement; 0: none
};

/// A picture that gnuplot draws from a table.
struct Plot {
  std::string name;    ///< of its files, without ending: "figure-6.9"
  std::string script;  ///< to follow `plot_preamble`; names files in its own folder
};

/// A table on a page, with what is to be said above it.
struct ShownTable {
  std::string text;
  std::vector<ShownColumn> columns;
};

struct ExperimentResult {
  std::string title;
  Table table;                       ///< NAME.csv
  std::vector<ShownTable> shown;     ///< NAME.md, each of them all rows
  std::vector<std::string> summary;  ///< what the index says of it, a line each, with the fits
  std::vector<Plot> plots;
  std::vector<std::string> wrong;  ///< engines that disagree, measurements that died
};

/// One of the experiments of chapter 6.
struct Experiment {
  std::string name;
  std::string what;  ///< a line
  ExperimentResult (*run)(const ExperimentSettings& settings);
};

/// All experiments, in the order of the thesis.
const std::vector<Experiment>& experiments();

ExperimentResult run_table_6_1(const ExperimentSettings& settings);
ExperimentResult run_convex_star(const ExperimentSettings& settings);
ExperimentResult run_star_star(const ExperimentSettings& settings);
ExperimentResult run_simple_simple(const ExperimentSettings& settings);
ExperimentResult run_fork_l(const ExperimentSettings& settings);
ExperimentResult run_hole_tests(const ExperimentSettings& settings);
ExperimentResult run_cycles(const ExperimentSettings& settings);

}  // namespace oplus
