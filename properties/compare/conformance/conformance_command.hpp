// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Adds `conformance`: all that must hold of sums, against one implementation. Sets the exit code when
/// run: 0 it conforms, 1 it does not, 2 bad input or a request that makes no sense.
void add_conformance_command(CLI::App& app, int& exit_code);

}  // namespace oplus
