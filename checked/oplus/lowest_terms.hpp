// SPDX-License-Identifier: MIT
#pragma once

#include "checked/oplus/oplus.hpp"

namespace oplus {

/// Returns a point of the user's, whose coordinates may be unreduced fractions. Throws InvalidInput where a
/// denominator is zero.
inline Point in_lowest_terms(const Point& p) { return Coordinates(p).point(); }

}  // namespace oplus
