// SPDX-License-Identifier: MIT
#pragma once

#include "checked/slide/near_number.hpp"

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
  friend int turn(const IntegerVector& a, const IntegerVector& b) {
    const int certain = certain_turn(a, b);
    return certain != 0 ? certain : sign_of(cross(a, b));
  }
  /// The same where leading digits tell it, or 0, of numbers of GMP.
  friend int certain_turn(const IntegerVector& a, const IntegerVector& b) {
    if constexpr (is_of_gmp<Value>)
      return certain_order(near_number(a.x) * near_number(b.y),
                           near_number(a.y) * near_number(b.x));
    else
      return 0;
  }
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
