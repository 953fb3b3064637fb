// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "checked/slide/near_number.hpp"
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

/// value / 2^shift as a double, however large it is, off by a rounding, or two if it is a rational.
template <typename Value>
double scaled_down(const Value& value, std::size_t shift) {
  if constexpr (is_of_gmp<Value>)
    return near_number(value).scaled_down(shift);
  else
    return std::ldexp(to_double(value), -static_cast<int>(shift));
}

/// n / d as a double, however large both are, off by at most 2^-50 of its size or 2^-1000.
template <typename Value>
double quotient(const Value& n, const Value& d) {
  if constexpr (is_of_gmp<Value>)
    return (near_number(n) / near_number(d)).scaled_down(0);
  else
    return to_double(n) / to_double(d);
}

/// A place on the line of a segment: 0 is its source, 1 its target.
template <typename Numbers>
class Fraction {
 public:
  /// Integers, of rationals too: they are faster, since they are not reduced after each operation.
  using Value =
      std::conditional_t<is_rational<Numbers>, AnyNumbers::Value, typename Numbers::Value>;

  /// The quotient of two rationals. Requires: d > 0.
  template <typename Quotient>
  requires std::is_same_v<Quotient, RationalNumbers::Value> Fraction(const Quotient& n,
                                                                     const Quotient& d)
      : Fraction(
            Value(boost::multiprecision::numerator(n) * boost::multiprecision::denominator(d)),
            Value(boost::multiprecision::numerator(d) * boost::multiprecision::denominator(n))) {}

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
    using Product = std::conditional_t<is_rational<Numbers>, Value, typename Numbers::Product>;
    if constexpr (!is_small<Numbers>) {
      const double difference = b.near_ - a.near_;
      if (OPLUS_MUTANT("slide-believes-doubles",
                       "of two fractions in large numbers, doubles always tell the smaller") ||
          std::abs(difference) > 0x1p-48 * (std::abs(a.near_) + std::abs(b.near_)) + 0x1p-900)
        return difference > 0;
    }
    if constexpr (!has_fixed_width<Numbers>) {
      const int order = certain_order(near_number(a.numerator_) * near_number(b.denominator_),
                                      near_number(b.numerator_) * near_number(a.denominator_));
      if (order != 0) return order < 0;
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
