// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// Adds `merge`: the reports of the shards of one campaign as one. Sets the exit code when run to that
/// of the campaign: 0 all is as it should be, 1 it is not; 2 the reports are not those of all shards of
/// one campaign.
void add_merge_command(CLI::App& app, int& exit_code);

}  // namespace oplus
