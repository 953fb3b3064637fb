// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/statement.hpp"

#include <exception>

namespace oplus {

Outcome evaluate(const Statement& statement, const Summands& summands) {
  if (!statement.check)
    return {Outcome::Kind::discarded, "it is enumerated, not tried on pairs", {}};
  try {
    return statement.check(summands);
  } catch (const std::exception& e) {
    return {Outcome::Kind::fails, std::string("threw: ") + e.what(), {}};
  }
}

Enumeration enumerated(const Statement& statement) {
  try {
    Enumeration result = statement.enumerate();
    if (result.cases == 0 && result.failure.empty()) result.failure = "no case was enumerated";
    return result;
  } catch (const std::exception& e) {
    return {0, std::string("threw: ") + e.what()};
  }
}

}  // namespace oplus
