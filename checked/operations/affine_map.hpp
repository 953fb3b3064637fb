// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/values.hpp"

namespace oplus {

/// The map that takes (x, y) to (a x + b y, c x + d y), moved by `by`. By default each point stays where
/// it is.
struct AffineMap {
  Rational a = 1;  ///< how x changes with x
  Rational b = 0;  ///< how x changes with y
  Rational c = 0;  ///< how y changes with x
  Rational d = 1;  ///< how y changes with y
  Vector by = {};  ///< where the origin goes

  /// Returns how areas change; negative where left and right are exchanged.
  Rational determinant() const { return a * d - b * c; }

  /// Returns where the map takes a point.
  Point operator()(const Point& p) const {
    return {a * p.x + b * p.y + by.x, c * p.x + d * p.y + by.y};
  }

  friend bool operator==(const AffineMap&, const AffineMap&) = default;
};

/// Returns the map that does `first` what stands on the right: (second * first)(p) = second(first(p)).
inline AffineMap operator*(const AffineMap& second, const AffineMap& first) {
  return {second.a * first.a + second.b * first.c, second.a * first.b + second.b * first.d,
          second.c * first.a + second.d * first.c, second.c * first.b + second.d * first.d,
          second(first.by)};
}

}  // namespace oplus
