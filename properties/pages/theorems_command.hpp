// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Adds `theorems`; sets exit_code when run.
void add_theorems_command(CLI::App& app, int& exit_code);

}  // namespace oplus
