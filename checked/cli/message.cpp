// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/message.hpp"

#include <algorithm>
#include <iostream>

namespace oplus {

void say(const std::string& message) {
  std::string line = message;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  std::cerr << "oplus: " + line + "\n" << std::flush;
}

}  // namespace oplus
