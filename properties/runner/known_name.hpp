// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace oplus {

/// Returns a function that refuses what is none of these names by UsageError: 'unknown statement
/// "lema-4.1.4"; did you mean lemma-4.1.4? HINT', where HINT says where all names are listed. The question
/// is left out where more than a third of the characters would have to change.
std::function<void(const std::string&)> known_name(const std::string& what,
                                                   const std::vector<std::string>& names,
                                                   const std::string& hint);

}  // namespace oplus
