// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "checked/engine.hpp"
#include "properties/compare/no_sum.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// What an implementation answers when asked for a sum: the sum, or why there is none.
struct Answer {
  std::optional<MinkowskiSum> sum;
  NoSum::Kind no_sum = NoSum::Kind::crashed;  ///< where there is none
  std::string site;                           ///< likewise, as NoSum has it
  std::string what;                           ///< likewise, a line
};

/// An exception of an implementation is an answer, too. One that is no NoSum is a crash, its words
/// without digits the site. Throws std::system_error where the implementation does: it was not asked.
Answer ask(const Engine& implementation, const Region& p, const Region& q, Boundary boundary);

}  // namespace oplus
