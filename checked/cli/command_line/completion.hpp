// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "checked/cli/command_line/description.hpp"

namespace oplus {

// Each returns a script that completes the program's commands, options, and their values: names
// where only some are taken, else files or folders. None needs more than its shell.

std::string bash_completion(const DescribedProgram& program);
std::string zsh_completion(const DescribedProgram& program);
std::string fish_completion(const DescribedProgram& program);

/// The name of a shell function for a program: "oplus-check" as "_oplus_check".
std::string function_name(const std::string& program);

/// The text in single quotes of a POSIX shell.
std::string in_quotes(const std::string& text);

}  // namespace oplus
