// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/bench/fit.hpp"
#include "tests/bench/table.hpp"

namespace CLI {
class App;
}

namespace oplus {

struct ExperimentSettings {
  std::uint64_t seed = 1;
  double scale = 1;                    ///< of the largest size of each family
  std::size_t memory_limit_mb = 8000;  ///< of one measurement; 0: unlimited
  std::vector<std::string> only = {};  ///< experiments; empty: all
  std::string out = "oplus-experiments";
};

/// A picture that gnuplot draws of an experiment's CSV: its script is pages/NAME.gp.mustache.
struct Plot {
  std::string name;
  std::string needs;        ///< drawn if a row has this number
  std::string family = "";  ///< and this `family`; empty: any
};

/// One of the experiments of chapter 6; its page is pages/NAME.md.mustache.
struct Experiment {
  std::string name;
  std::string what;  ///< a line
  std::function<std::vector<Row>(const ExperimentSettings& settings)> rows = {};
  void (*compare)(Row& row) = nullptr;          ///< adds words and numbers that compare engines
  std::vector<std::string> first_columns = {};  ///< of its CSV
  std::vector<std::string> (*summary)(const Rows& rows) = nullptr;  ///< the index's lines about it
  std::vector<Plot> plots = {};

  /// The curve that plots show through the times of rca and winding: a line (1), a parabola (2).
  std::size_t fitted_degree = 0;
  std::string fitted_over = "";  ///< the number that is its x; empty: no curve
};

/// All experiments, in the order of the thesis.
const std::vector<Experiment>& experiments();

/// The experiments about engines of sums, about hole tests, and about cycle tracing.
std::vector<Experiment> sum_experiments();
Experiment hole_test_experiment();
Experiment cycle_experiment();

/// Adds the command `experiments`, which measures chapter 6 of the thesis again. Returns the function that
/// runs it. Its exit code is 0 if all is written, 1 if engines disagree or one of ours crashed or failed, 4
/// if all but the plots is written, because gnuplot is missing or fails. It throws UsageError, and
/// std::system_error if a file cannot be written.
std::function<int()> add_experiments_command(CLI::App& app);

}  // namespace oplus
