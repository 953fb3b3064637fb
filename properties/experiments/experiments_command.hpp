// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Adds `experiments`: chapter 6 of the thesis measured again. Sets the exit code when run: 0 all is
/// written, 1 engines disagree or a measurement died, 2 a request that makes no sense or a file that
/// cannot be written, 4 all but the plots is written, as gnuplot is missing or fails.
void add_experiments_command(CLI::App& app, int& exit_code);

}  // namespace oplus
