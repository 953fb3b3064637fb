// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "properties/fuzz/pair_plan.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// A change of structure: of one vertex, of chains, of a summand, of the numbers. `apply` returns
/// false, and leaves a plan that it must not be judged by, where there is nothing to change.
struct PairChange {
  std::string name;
  bool (*apply)(Random& random, PairPlan& plan);
};
const std::vector<PairChange>& pair_changes();

/// A plan after one to three changes; among several tries the first that is realized as planned and
/// is another one. A new plan where no try is.
PairPlan mutated_plan(Random& random, const PairPlan& plan);

/// Summands, chains and numbers from both; tried likewise.
PairPlan crossed_plan(Random& random, const PairPlan& a, const PairPlan& b);

/// A plan of two random regions, with holes and several components as often as not.
PairPlan new_plan(Random& random);

/// The same of the bytes.
std::string mutated_pair(Random& random, std::string_view bytes);
std::string crossed_pair(Random& random, std::string_view a, std::string_view b);

}  // namespace oplus
