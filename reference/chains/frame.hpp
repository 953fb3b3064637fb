// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

// An unbounded set is summed within a frame: a rectangle around it takes the place of the outer chain that
// is missing, and is left out of the result (docs/operations.md).

/// The width or the height, whichever is larger, of a set that is not empty; 0 where it has no chain, edge or
/// point.
Rational extent(const Region& region);
Rational extent(const PlanarSet& set);

/// Gives an unbounded set an outer chain: the rectangle whose sides are `margin` away from the box around
/// all its chains, edges and points; from the origin where it has none. A bounded set stays as it is. At most
/// one component gets one. Requires: margin > 0.
Region framed(Region region, const Rational& margin);
PlanarSet framed(PlanarSet set, const Rational& margin);

/// Takes away the outer chain that is around all others; the set is unbounded then.
/// Requires: there is such a chain.
PlanarSet unframed(PlanarSet set);

}  // namespace oplus
