// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Adds `exhaustive`; sets exit_code when run: 0 all agree, 1 a disagreement, 2 bad input or a request
/// that makes no sense, 5 interrupted before the end.
void add_exhaustive_command(CLI::App& app, int& exit_code);

}  // namespace oplus
