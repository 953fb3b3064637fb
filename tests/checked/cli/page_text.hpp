// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <regex>
#include <string>
#include <vector>

namespace oplus {

/// What matches the first group of the pattern, all of it.
inline std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  return {std::sregex_token_iterator(text.begin(), text.end(), expression, 1), {}};
}

/// The commands of a page that call `oplus`, in their order, without comments.
inline std::vector<std::string> commands_of(const std::string& page) {
  return found(page, "\n    (oplus .*?)(?: #.*)?(?=\n)");
}

}  // namespace oplus
