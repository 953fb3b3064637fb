// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/point.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// Returns the integer point next to that at distance `radius` from the origin in a random
/// direction, each direction equally likely. No rounded arithmetic: libm differs between machines.
Point circle_point(Random& random, const mpz_class& radius);

}  // namespace oplus
