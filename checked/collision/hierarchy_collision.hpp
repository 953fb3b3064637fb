// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "checked/collision/collision_test.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// The collision test by two hierarchies of bounding volumes, built once, of which that of -Q is
/// translated (thesis, Section 5.1.2). About O(log n + log m) where the interiors meet, by
/// experience; O(nm) at worst.
/// Requires: p and q are valid (validity.hpp).
std::unique_ptr<CollisionTest> hierarchy_collision(const Region& p, const Region& q);

}  // namespace oplus
