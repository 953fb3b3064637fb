// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "checked/slide/fraction.hpp"

namespace oplus::slide {

/// A place inside a piece: near its middle, in short numbers, or else the mediant of its ends.
template <typename Numbers>
Fraction<Numbers> place_inside(const Piece<Numbers>& piece) {
  const double low = piece.from.near(), high = piece.to.near();
  const double width = high - low;
  if (width > 0x1p-40) {
    const int exponent = 1 - std::ilogb(width);
    const double rounded = std::round(std::ldexp((low + high) / 2, exponent));
    Fraction<Numbers> t{static_cast<std::int64_t>(rounded), std::int64_t{1} << exponent};
    if (piece.from < t && t < piece.to) return t;
  }
  return {piece.from.numerator() + piece.to.numerator(),
          piece.from.denominator() + piece.to.denominator()};
}

}  // namespace oplus::slide
