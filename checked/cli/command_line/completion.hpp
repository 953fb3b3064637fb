// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace oplus {

struct Program;

/// The completions of the last of these words, by the definitions that the program parses with: a line
/// each, the word and, behind a tab, what it is. Where the name of a file or a folder is expected, the
/// one line ":files" or ":folders": the shell completes them.
/// Requires: words are those behind the program's name, with at least one, which may be empty.
std::string completions(const CLI::App& program, const std::vector<std::string>& words);

/// Adds the command `completion`, which prints a script for a shell that asks the program for
/// completions: `PROGRAM --complete WORD...`. Its work throws UsageError where it cannot write.
void add_completion_command(Program& program);

}  // namespace oplus
