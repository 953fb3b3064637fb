// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "properties/compare/peers/method.hpp"

namespace oplus {

/// Regions scaled to integers, for methods that compute with integers and round to them. The larger the
/// scale, the smaller the rounding errors, so it is as large as the range allows.
struct IntegerScale {
  Rational factor;

  /// The common denominator of all coordinates.
  static IntegerScale least(const std::vector<Region>& regions);

  /// The largest power of two, times that denominator, with which all coordinates of the regions and of
  /// the sum of any two are at most `most`; that denominator, where this needs more, but not more than `limit`.
  /// Throws Unsupported otherwise.
  static IntegerScale of(const std::vector<Region>& regions, const mpz_class& most,
                         const mpz_class& limit);

  /// Requires: value is a coordinate of the regions.
  long scaled(const Rational& value) const;

  /// Back from the method's coordinates.
  Point point(long x, long y) const { return {Rational(x) / factor, Rational(y) / factor}; }
};

}  // namespace oplus
