// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Adds `diff`: implementations against the oracle. Sets the exit code when run: 0 all agree, 1 a
/// disagreement, 2 bad input or a request that makes no sense.
void add_diff_command(CLI::App& app, int& exit_code);

}  // namespace oplus
