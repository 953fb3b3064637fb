// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace oplus {

/// What both programs have in common: help and its form, --version, --quiet and --color, which may
/// stand before a command or behind it.
/// Requires: the program has no command yet.
void set_up(CLI::App& program);

/// Takes work that is to be done if the command line is understood.
using Choose = std::function<void(std::function<void()>)>;

/// Adds the commands `completion` and `man`, which describe the program they are added to. Their
/// work throws UsageError where it cannot write.
void add_completion_command(CLI::App& program, const Choose& choose);
void add_man_command(CLI::App& program, const Choose& choose);

/// What is wrong with a command line, and which help to read.
std::string complaint(const CLI::App& program, const CLI::ParseError& error);

/// Opens standard streams that were closed before the start, the wrong way round, so that their use
/// fails: the first file opened would otherwise take their place.
void occupy_closed_streams();

/// Writes a file or standard output (-). Throws UsageError.
void write_text(const std::string& path, const std::string& text);

}  // namespace oplus
