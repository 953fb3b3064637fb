// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "reference/io/writing.hpp"

namespace oplus {

/// Adds `--format wkt|dat|geojson`.
void add_format_option(CLI::App& subcommand, std::optional<Format>& format);

}  // namespace oplus
