// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "checked/collision/collision_test.hpp"

namespace oplus {

/// The collision test that compares each edge of P with each of -Q+x (thesis, Section 5.1): O(nm)
/// unless an early pair crosses. What the two fast ones are measured against.
/// Requires: p and q are valid (validity.hpp).
std::unique_ptr<CollisionTest> naive_collision(const Region& p, const Region& q);

}  // namespace oplus
