// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Adds `oplus-maintain fuzz`.
void add_fuzz_command(CLI::App& app, int& exit_code);

}  // namespace oplus
