// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/checked/cli/page_text.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {

inline const std::vector<std::string> programs = {"oplus", "oplus-check"};

/// Commands and options as the help texts list them.
class HelpPages : public Shell {
 protected:
  std::string help(const std::string& command) const { return run(command + " --help").out; }

  std::vector<std::string> commands(const std::string& program) const {
    const std::string text = help(program);
    const std::size_t start = text.find("\nSubcommands:\n") + 12;
    return found(text.substr(start, text.find("\n\n", start) - start), "\n  ([a-z-]+)");
  }

  /// Of a command, or of a program: -o, --output, ....
  std::vector<std::string> options(const std::string& command) const {
    std::vector<std::string> names;
    for (const std::string& both : found(help(command), "\n  (-[^ \n]*)"))
      for (const std::string& name : found(both, "(--?[a-zA-Z-]+)")) names.push_back(name);
    return names;
  }
};

}  // namespace oplus
