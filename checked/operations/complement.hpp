// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/values.hpp"

namespace oplus {

/// The complement of a set. That of an open one is closed, and the reverse: dangling edges and isolated
/// vertices, which are outside an open set, are in its complement. Near-linear.
PlanarSet complement(const PlanarSet& set);

/// The closure of a region's complement, a region again, which may be unbounded, as the given one may.
Region complement(const Region& region);

}  // namespace oplus
