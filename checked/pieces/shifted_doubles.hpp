// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "checked/pieces/place.hpp"
#include "reference/definitions/values.hpp"

namespace oplus::pieces {

/// 2 to this power is larger than |numerator / denominator|, and at most four times as large unless that is 0.
inline long bits_of(const mpz_class& numerator, const mpz_class& denominator) {
  return static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) -
         static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2)) + 1;
}

/// How rationals become doubles: divided by a power of two where they, or products of four, could be
/// too large for doubles or too small.
class ShiftedDoubles {
 public:
  ShiftedDoubles() = default;

  explicit ShiftedDoubles(std::span<const Point> points) {
    bool is_first = true;
    for (const Point& p : points) {
      for (const Rational* x : {&p.x, &p.y}) {
        if (sgn(*x) == 0) continue;
        const long more = bits_of(x->get_num(), x->get_den());
        bits_ = is_first ? more : std::max(bits_, more);
        is_first = false;
      }
    }
    if (std::abs(bits_) > most_bits) shift_ = bits_;
  }

  long bits() const { return bits_; }  ///< 2 to this power is larger than any of the coordinates

  /// Off by less than 2^-50 of its size; exact if it is an integer below 2^53 that is not shifted.
  double near(const mpz_class& numerator, const mpz_class& denominator) const {
    if (shift_ == 0 && denominator == 1 && mpz_sizeinbase(numerator.get_mpz_t(), 2) <= 53)
      return numerator.get_d();
    long of_numerator = 0, of_denominator = 0;
    const double n = mpz_get_d_2exp(&of_numerator, numerator.get_mpz_t());
    const double d = mpz_get_d_2exp(&of_denominator, denominator.get_mpz_t());
    const long exponent = std::clamp(of_numerator - of_denominator - shift_, -2000L, 2000L);
    return std::ldexp(n / d, static_cast<int>(exponent));
  }
  double near(const Rational& value) const { return near(value.get_num(), value.get_den()); }
  Place near(const Point& p) const { return {near(p.x), near(p.y)}; }

 private:
  static constexpr long most_bits = 100;

  long bits_ = 0;
  long shift_ = 0;
};

}  // namespace oplus::pieces
