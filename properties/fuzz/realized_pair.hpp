// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "properties/fuzz/pair_plan.hpp"

namespace oplus {

/// A valid pair, and how far it differs from its plan.
struct RealizedPair {
  Summands summands;
  std::size_t untangled = 0;  ///< chains that were not simple, whose vertices were put in order
  std::size_t left_out = 0;   ///< chains that could not become a part of a valid region

  bool is_as_planned() const { return untangled == 0 && left_out == 0; }
};

/// Returns the pair of a plan, valid (validity.hpp), each summand with at least one component; nullopt
/// where one has none left. Chains are oriented, untangled or left out, one after another.
std::optional<RealizedPair> realized(const PairPlan& plan);

}  // namespace oplus
