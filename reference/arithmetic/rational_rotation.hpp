// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/rational.hpp"

namespace oplus {

/// A rotation that takes rational points to rational points: cos² + sin² = 1, exactly.
struct RationalRotation {
  Rational cos = 1;  ///< the cosine of the angle, counterclockwise
  Rational sin = 0;  ///< its sine

  friend bool operator==(const RationalRotation&, const RationalRotation&) = default;
};

/// Returns a rotation by an angle that differs from `degrees` by at most `error`, also in degrees:
///  1. a multiple of 90 degrees is met exactly;
///  2. any other angle is not met, as no rational rotation is by another rational number of degrees
///     (Niven's theorem); the rotation returned has the smallest denominator of all that are within the
///     error, the last 2^-32 of which is left out;
///  3. the rotation by the opposite angle is the inverse one.
/// Requires: error > 0. Cost: that of numbers with as many bits as the error has, and 64 more.
RationalRotation rational_rotation(const Rational& degrees, const Rational& error);

/// Returns the angle of a rotation in degrees, from above -180 to 180; differs from the exact one by at
/// most `error`. Requires: cos² + sin² = 1; error > 0.
Rational angle_in_degrees(const RationalRotation& rotation, const Rational& error);

}  // namespace oplus
