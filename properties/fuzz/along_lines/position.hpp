// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "properties/fuzz/along_lines/integers.hpp"

namespace oplus::along_lines {

/// A place on a line: its x, or y on vertical lines, less that of the line's first point.
template <typename T>
struct Position {
  double near, error;
  T numerator = 0, denominator = 0;  ///< positive, or zero as long as `near` is enough
};

/// Beyond what doubles hold, equal to all: then integers decide.
template <typename T>
Position<T> position(T numerator, T denominator) {
  if (denominator < 0) {
    numerator = T(-numerator);
    denominator = T(-denominator);
  }
  const double a = as_double(numerator), b = as_double(denominator);
  const double near =
      std::isfinite(a) && std::isfinite(b) ? a / b : std::numeric_limits<double>::quiet_NaN();
  return {near, std::abs(near) * 1e-15, std::move(numerator), std::move(denominator)};
}

template <typename T>
int compare_exactly(const Position<T>& a, const Position<T>& b) {
  return sign_of(T(a.numerator * b.denominator - b.numerator * a.denominator));
}

}  // namespace oplus::along_lines
