// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "checked/slide/number_types.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// Off by at most a few roundings.
template <typename Value>
double to_double(const Value& value) {
  if constexpr (std::is_same_v<Value, std::int64_t> || std::is_same_v<Value, WideNumbers::Value>)
    return static_cast<double>(value);
  else
    return value.template convert_to<double>();
}

/// A number is near mantissa 2^exponent, off by at most 2^-51 of its size.
struct NearNumber {
  double mantissa;
  long exponent;

  double scaled_down(std::size_t shift) const {
    return std::ldexp(mantissa, static_cast<int>(exponent - static_cast<long>(shift)));
  }
  friend NearNumber operator/(const NearNumber& a, const NearNumber& b) {
    return {a.mantissa / b.mantissa, a.exponent - b.exponent};
  }
};

inline NearNumber near_number(mpz_srcptr value) {
  NearNumber near;
  near.mantissa = mpz_get_d_2exp(&near.exponent, value);
  return near;
}

inline NearNumber near_number(const boost::multiprecision::mpq_rational& value) {
  mpq_srcptr quotient = value.backend().data();
  return near_number(mpq_numref(quotient)) / near_number(mpq_denref(quotient));
}

/// value / 2^shift as a double, however large it is, off by a rounding, or two if it is a rational.
template <typename Value>
double scaled_down(const Value& value, std::size_t shift) {
  if constexpr (std::is_same_v<Value, boost::multiprecision::mpz_int>) {
    return near_number(value.backend().data()).scaled_down(shift);
  } else if constexpr (std::is_same_v<Value, boost::multiprecision::mpq_rational>) {
    return near_number(value).scaled_down(shift);
  } else {
    return std::ldexp(to_double(value), -static_cast<int>(shift));
  }
}

/// n / d as a double, however large both are, off by at most 2^-50 of its size or 2^-1000.
template <typename Value>
double quotient(const Value& n, const Value& d) {
  if constexpr (std::is_same_v<Value, boost::multiprecision::mpz_int>) {
    const std::size_t shift = mpz_sizeinbase(d.backend().data(), 2);
    return scaled_down(n, shift) / scaled_down(d, shift);
  } else if constexpr (std::is_same_v<Value, boost::multiprecision::mpq_rational>) {
    return (near_number(n) / near_number(d)).scaled_down(0);
  } else {
    return to_double(n) / to_double(d);
  }
}

/// A place on the line of a segment: 0 is its source, 1 its target.
template <typename Numbers>
class Fraction {
 public:
  using Value = typename Numbers::Value;

  /// Requires: denominator > 0.
  Fraction(Value numerator, Value denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    if constexpr (!is_small<Numbers>) near_ = quotient(numerator_, denominator_);
  }

  const Value& numerator() const { return numerator_; }
  const Value& denominator() const { return denominator_; }

  /// Off by at most 2^-50 of its size or 2^-1000.
  double near() const {
    if constexpr (is_small<Numbers>)
      return quotient(numerator_, denominator_);
    else
      return near_;
  }

  /// Exact: in the larger numbers, doubles decide where they are certain.
  friend bool operator<(const Fraction& a, const Fraction& b) {
    using Product = typename Numbers::Product;
    if constexpr (!is_small<Numbers>) {
      const double difference = b.near_ - a.near_;
      if (OPLUS_MUTANT("slide-believes-doubles",
                       "of two fractions in large numbers, doubles always tell the smaller") ||
          std::abs(difference) > 0x1p-48 * (std::abs(a.near_) + std::abs(b.near_)) + 0x1p-900)
        return difference > 0;
    }
    return Product(a.numerator_) * Product(b.denominator_) <
           Product(b.numerator_) * Product(a.denominator_);
  }

 private:
  struct Nothing {};

  Value numerator_;
  Value denominator_;
  [[no_unique_address]] std::conditional_t<is_small<Numbers>, Nothing, double> near_{};
};

/// Closed.
template <typename Numbers>
struct Piece {
  Fraction<Numbers> from;
  Fraction<Numbers> to;
};

}  // namespace oplus::slide
