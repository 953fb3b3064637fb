// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/collision/collision_test.hpp"

namespace oplus {

/// A collision test by sweeping a line over both boundaries (thesis, Section 5.1.1): stops where the
/// first crossing or contact shows that the interiors meet, so no more than that one crossing is
/// found, whatever their number: O((n+m) log(n+m)).
/// Requires: p and q are valid (validity.hpp).
std::unique_ptr<CollisionTest> sweep_collision(const Region& p, const Region& q);

}  // namespace oplus
