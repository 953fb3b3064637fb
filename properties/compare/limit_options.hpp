// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include "properties/compare/engine_called.hpp"

namespace oplus {

/// Adds --time-limit and --memory-limit. The limits must live as long as the command.
void add_limit_options(CLI::App& command, PeerLimits& limits);

}  // namespace oplus
