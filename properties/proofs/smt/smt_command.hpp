// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace oplus {

/// oplus-check smt: statements about a few directions, proved by Z3 and by cvc5 (docs/smt.md).
void add_smt_command(CLI::App& app, int& exit_code);

}  // namespace oplus
