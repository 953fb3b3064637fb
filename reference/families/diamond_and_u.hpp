// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/families/family.hpp"

namespace oplus {

/// A room with a hatch of width 1 in its roof, from (3,5) and (4,5) up to (3-eps1,6) and (4,6), and
/// a diamond of width 1 + eps2 (thesis, Section 6.4). With neither perturbation the diamond just
/// slides through: the open sum has a dangling edge between its hole and its outer chain.
/// Requires: 0 <= eps1 < 3, 0 <= eps2.
Summands diamond_and_u(const Rational& eps1, const Rational& eps2);

}  // namespace oplus
