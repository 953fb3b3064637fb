// SPDX-License-Identifier: MIT
#pragma once

#include "checked/operations/affine_map.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// The map that takes p to `factor` p.
AffineMap scaled_by(const Rational& factor);

/// Returns the image of a region. If the map reverses orientation, so are chains, each from its first
/// vertex, so that the interior stays to the left of each edge. It may be unbounded.
/// Requires: the determinant is not zero. Cost: n.
Region image(const AffineMap& map, Region region);

/// Returns the image of a sum or another set, in canonical form. It may be unbounded.
/// Requires: the determinant is not zero. Cost: n log n.
PlanarSet image(const AffineMap& map, const PlanarSet& sum);

}  // namespace oplus
