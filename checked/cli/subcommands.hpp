// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "checked/cli/exit_code.hpp"

namespace oplus {

/// What the command line asks for, done after all of it was understood.
using Action = std::function<ExitCode()>;

/// Each adds a subcommand, which sets `chosen` where it is the one asked for.
void add_sum(CLI::App& program, Action& chosen);
void add_compare(CLI::App& program, Action& chosen);
void add_verify(CLI::App& program, Action& chosen);
void add_certify(CLI::App& program, Action& chosen);
void add_draw(CLI::App& program, Action& chosen);
void add_gen(CLI::App& program, Action& chosen);
void add_reflect(CLI::App& program, Action& chosen);
void add_repair(CLI::App& program, Action& chosen);
void add_operations(CLI::App& program, Action& chosen);
void add_complement(CLI::App& program, Action& chosen);
void add_batch(CLI::App& program, Action& chosen);
void add_disc(CLI::App& program, Action& chosen);
void add_transform(CLI::App& program, Action& chosen);

}  // namespace oplus
