// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/oplus/engines.hpp"

#include "checked/engines/engines.hpp"

namespace oplus {

std::vector<std::string> engine_names() { return names_of(engines()); }

const Engine* engine(std::string_view name) {
  const Engine* const found = find_engine(engines(), name);
  if (found != nullptr) return found;
  std::string expected;
  for (const std::string& known : engine_names())
    expected += (expected.empty() ? "" : ", ") + known;
  throw std::invalid_argument("unknown engine " + std::string(name) + "; expected one of " +
                              expected);
}

}  // namespace oplus
