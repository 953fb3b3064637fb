// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "properties/experiments/experiment.hpp"
#include "properties/experiments/fit.hpp"

namespace oplus {

/// Points and perhaps a curve in one colour.
struct Series {
  std::string column;  ///< of y
  std::string title;
  std::string colour;
  std::optional<Fit> fit;
  std::string only_where;  ///< a condition on the row, as gnuplot reads it; empty: all rows
};

struct Axes {
  std::string title;
  std::string x_column;
  std::string x_label;
  std::string y_label;
  bool logarithmic = false;  ///< else both start at zero
  double y_factor = 1;       ///< 1e6 shows seconds as microseconds
};

/// The columns of a table NAME.csv against another; where no row has x and y there is no series, and
/// where there is no series no plot. Without a curve, lines join the means at each x.
std::optional<Plot> plot_of(const std::string& name, const std::string& csv, const Table& table,
                            const Axes& axes, const std::vector<Series>& series);

/// Adds those that exist.
void add(std::vector<Plot>& plots, std::optional<Plot> plot);

/// The script of a plot as a file of its own: `gnuplot NAME.gp` in its folder writes NAME.svg.
std::string to_gnuplot(const Plot& plot);

enum class Drawn { drawn, no_gnuplot, failed };

/// Runs gnuplot on NAME.gp, in the folder where it is.
Drawn draw(const std::filesystem::path& folder, const Plot& plot);

}  // namespace oplus
