// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "checked/cli/command_line/options.hpp"

namespace oplus {

/// A program: name, description and footer of its help.
struct ProgramFrame {
  std::string name;
  std::string what;
  std::string footer;
  bool shows_commands = false;  ///< whether a terminal shows that a command goes on (ShownStep)
};

/// Adds the commands of a program, at least those that it needs.
using AddCommands = void (*)(Program&);

/// A whole program: its commands and `completion`; --help, --version, --quiet and --color, which may
/// stand before a command or behind it. Returns the exit code; writes what went wrong to standard
/// error, in one line.
int run_program(const ProgramFrame& frame, AddCommands add_commands, int argc,
                const char* const* argv) noexcept;

/// Does the work. Returns its exit code, or that of what it throws (exit_code.hpp), after writing
/// the reason to standard error, in one line.
int exit_code_of(const std::function<int()>& work) noexcept;

}  // namespace oplus
