// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/compare/peers/method.hpp"

namespace oplus {

/// A pair scaled to integers, for methods that compute with integers and round to them. The larger the
/// scale, the smaller the rounding errors, so it is as large as the range allows.
struct IntegerScale {
  Rational factor;

  /// The largest power of two, times the common denominator, with which all coordinates of the
  /// summands and of their sum are at most `most`. Throws Unsupported where that is less than 1.
  static IntegerScale of(const Summands& pair, const mpz_class& most);

  /// Requires: value is a coordinate of the pair.
  long scaled(const Rational& value) const;

  /// Back from the method's coordinates.
  Point point(long x, long y) const { return {Rational(x) / factor, Rational(y) / factor}; }
};

}  // namespace oplus
