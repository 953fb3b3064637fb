// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// The matrix (a b; c d).
struct LinearMap {
  Rational a, b, c, d;

  Rational determinant() const { return a * d - b * c; }
  Point operator()(const Point& p) const { return {a * p.x + b * p.y, c * p.x + d * p.y}; }
};

LinearMap scaling(const Rational& factor);

/// The image of a region. If the map reverses orientation, chains are reversed, so that the
/// interior stays to the left of each edge. Requires: the determinant is not zero.
Region image(const LinearMap& map, const Region& region);

/// The image of a sum, translated, in canonical form. Requires: the determinant is not zero.
MinkowskiSum image(const LinearMap& map, const MinkowskiSum& sum, const Vector& by = {});

}  // namespace oplus
