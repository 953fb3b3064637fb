// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace oplus {

/// One of some names, for an option of the command line. Another is refused: 'unknown statement
/// "lema-4.1.4"; did you mean lemma-4.1.4? HINT', where HINT says where all names are listed. The question
/// is left out where more than a third of the characters would have to change. The names are completed.
CLI::Validator known_name(const std::string& what, const std::vector<std::string>& names,
                          const std::string& hint);

}  // namespace oplus
