// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

namespace oplus {

/// An option or an argument, as help, completion and manual show it.
struct DescribedOption {
  std::vector<std::string> names;    ///< "-o", "--output"; of an argument the one, "FILE"
  std::string what;                  ///< in the words of the program
  std::string value;                 ///< what it takes, "FILE"; empty for a flag
  std::vector<std::string> choices;  ///< where only these are taken
  std::string range;                 ///< "1 to 1024", or empty
  std::string preset;                ///< what holds without it, or empty
  std::vector<std::string> excludes = {};
  std::size_t values = 0;  ///< how many it takes at least; a flag none
  bool required = false;
  bool repeats = false;

  bool takes_files() const;
  bool takes_folders() const;
};

struct DescribedCommand {
  std::string name;
  std::string what;
  std::vector<DescribedOption> arguments;
  std::vector<DescribedOption> options;
  std::string footer;
};

/// A program of commands.
struct DescribedProgram {
  std::string name;
  std::string what;
  std::vector<DescribedOption> options;  ///< those that every command takes, too
  std::vector<DescribedCommand> commands;
  std::string footer;
};

/// Read off the definitions by which the program parses, so that nothing made of it is out of date.
DescribedOption described(const CLI::Option& option);
DescribedProgram described(const CLI::App& program);

/// "a description (one of a, b, c; default: b)": what the description leaves out is added.
std::string full_description(const DescribedOption& option);

/// What the description says first, for where there is one line: "how to compute".
std::string short_description(const DescribedOption& option);

/// Whether each command takes an option of the program as well.
bool is_for_every_command(const CLI::Option& option);

}  // namespace oplus
