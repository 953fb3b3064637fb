// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Add the commands that compare engines with the oracle or with winding numbers, and `merge`. Each sets exit_code when run:
/// 0 all agree; 1 a disagreement; 5 interrupted before the end.
/// Throw InvalidInput, UsageError or std::system_error when run, also where nothing was compared.
void add_diff_command(CLI::App& app, int& exit_code);
void add_exhaustive_command(CLI::App& app, int& exit_code);
void add_conformance_command(CLI::App& app, int& exit_code);
void add_merge_command(CLI::App& app, int& exit_code);

}  // namespace oplus
