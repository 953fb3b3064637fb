// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/experiment.hpp"
#include "tests/bench/templates.hpp"

namespace oplus {

/// Writes NAME.csv, NAME.md and NAME.gp of each plot that can be drawn. Returns what the index says of
/// the experiment, and appends the plots' names. Throws std::system_error.
PageData write_experiment(const std::filesystem::path& folder, const Experiment& experiment,
                          const Rows& rows, const std::vector<std::string>& faults,
                          std::vector<std::string>& plots);

/// Writes index.md from what write_experiment returned, in a list: settings, the machine, and what a
/// process needs that measures nothing.
void write_index(const std::filesystem::path& folder, const ExperimentSettings& settings,
                 const PageData& experiments);

enum class Drawn { drawn, no_gnuplot, failed };

/// Runs gnuplot on NAME.gp in its folder, which writes NAME.svg.
Drawn draw(const std::filesystem::path& folder, const std::string& plot);

}  // namespace oplus
