// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Add `pages` and `theorems`; each sets exit_code when run. Of `pages`: 0 written or up to date, 1
/// out of date, 2 a record is invalid.
void add_pages_command(CLI::App& app, int& exit_code);
void add_theorems_command(CLI::App& app, int& exit_code);

}  // namespace oplus
