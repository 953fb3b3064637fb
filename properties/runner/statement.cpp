// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/statement.hpp"

#include <exception>

namespace oplus {

Outcome evaluate(const Statement& statement, const Summands& summands) {
  try {
    return statement.check(summands);
  } catch (const std::exception& e) {
    return {Outcome::Kind::fails, std::string("threw: ") + e.what(), {}};
  }
}

}  // namespace oplus
