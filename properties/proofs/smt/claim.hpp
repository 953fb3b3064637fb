// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "properties/proofs/smt/values.hpp"

namespace oplus::smt {

/// What is claimed of values: a formula in the unknowns, or true or false of a model.
using Claim = std::function<Formula(const Values&)>;

Claim all_of(const std::vector<Claim>& parts);
Claim any_of(const std::vector<Claim>& parts);
Claim negation(const Claim& claim);
Claim same(const Claim& a, const Claim& b);
Claim if_then_else(const Claim& condition, const Claim& then, const Claim& otherwise);

/// A claim that does not depend on the values.
Claim fact(bool holds);

/// The claim that code returns true.
Claim executed(const std::function<bool(const Values&)>& code);

}  // namespace oplus::smt
