// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "reference/definitions/region.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// A polygon like a coastline: a triangle whose longest edge gets a vertex to either side of its
/// middle, again and again, wherever the boundary stays simple. One counterclockwise chain of exactly
/// n vertices, bays in bays, on integers from 0 to 2^20. Requires: n >= 3.
Region coast_polygon(Random& random, std::size_t n);

}  // namespace oplus
