// SPDX-License-Identifier: MIT
#pragma once

#include "reference/arithmetic/floor_of.hpp"

namespace oplus {

/// The fraction from low to high with the smallest denominator, and with the smallest numerator among
/// those; both are smallest at once. Requires: 0 <= low <= high.
inline Rational simplest_between(const Rational& low, const Rational& high) {
  const mpz_class whole = floor_of(low);
  if (whole == low) return whole;
  if (whole + 1 <= high) return whole + 1;
  return whole + 1 / simplest_between(1 / (high - whole), 1 / (low - whole));
}

}  // namespace oplus
