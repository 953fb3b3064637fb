// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/collision/collision_test.hpp"
#include "properties/runner/statement.hpp"

namespace oplus {

/// Whether a method answers as the definition (`interiors_meet`) does at every kind of placement there
/// is. Counts them by their strongest contact and by the answer.
Outcome collision_outcome(CollisionMethod method, const Summands& summands);

}  // namespace oplus
