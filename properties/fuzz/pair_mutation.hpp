// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "properties/fuzz/pair_plan.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// A change of structure: of one vertex, of chains, of a summand, of the numbers. `apply` returns
/// false where nothing could be changed; the plan is then unspecified.
/// Requires: each summand has a chain; keeps that.
struct PairChange {
  std::string name;
  bool (*apply)(Random& random, PairPlan& plan);
};
const std::vector<PairChange>& pair_changes();

/// A plan of two random regions, with holes and several components as often as not.
PairPlan new_plan(Random& random);

/// The bytes of a plan after one to three changes; among several tries the first that is realized as
/// planned and differs from the first. If none is, a new plan.
std::string mutated_pair(Random& random, std::string_view bytes);

/// Summands, chains and numbers from both; tried likewise.
std::string crossed_pair(Random& random, std::string_view a, std::string_view b);

}  // namespace oplus
