// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "properties/experiments/experiment.hpp"
#include "properties/experiments/plot.hpp"

namespace oplus {

/// Writes NAME.csv, NAME.md and the scripts of its plots. Throws std::system_error.
void write_experiment(const std::filesystem::path& folder, const Experiment& experiment,
                      const ExperimentResult& result);

/// What the index says of an experiment: its summary, and where its table and plots are.
std::string index_entry(const Experiment& experiment, const ExperimentResult& result);

/// What the index starts with: settings, machine, and what a process needs that measures nothing.
std::string index_head(const ExperimentSettings& settings);

}  // namespace oplus
