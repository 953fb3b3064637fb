// SPDX-License-Identifier: MIT
#pragma once

#include "checked/slide/number_types.hpp"

namespace oplus::slide {

template <typename Numbers>
struct IntegerVector {
  using Value = typename Numbers::Value;

  Value x;
  Value y;

  friend IntegerVector operator+(const IntegerVector& a, const IntegerVector& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend IntegerVector operator-(const IntegerVector& a, const IntegerVector& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend IntegerVector operator-(const IntegerVector& a) { return {-a.x, -a.y}; }
  friend Value cross(const IntegerVector& a, const IntegerVector& b) {
    return a.x * b.y - a.y * b.x;
  }
  /// Whether b is to the left of a, 1, or to the right, -1.
  friend int turn(const IntegerVector& a, const IntegerVector& b) { return sign_of(cross(a, b)); }
  /// Whether its angle is at least π.
  bool is_lower() const { return y < 0 || (y == 0 && x < 0); }
  friend Value dot(const IntegerVector& a, const IntegerVector& b) { return a.x * b.x + a.y * b.y; }
};

/// From `source`, as far as `direction` goes.
template <typename Numbers>
struct IntegerSegment {
  IntegerVector<Numbers> source;
  IntegerVector<Numbers> direction;
};

}  // namespace oplus::slide
