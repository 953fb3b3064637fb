// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "checked/slide/number_types.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// mantissa 2^exponent, for numbers of GMP that are out of the range of doubles. Each operation is off by at most
/// 2^-52 of the size of its operands or, of products and quotients, of its result. Requires: mantissas are 0 or
/// between 2^-20 and 2^20, as they are in few operations: sums have some from 1/2 to 1.
struct NearNumber {
  double mantissa;
  long exponent;

  double scaled_down(std::size_t shift) const {
    return std::ldexp(mantissa, static_cast<int>(exponent - static_cast<long>(shift)));
  }
  friend NearNumber operator*(const NearNumber& a, const NearNumber& b) {
    return {a.mantissa * b.mantissa, a.exponent + b.exponent};
  }
  friend NearNumber operator/(const NearNumber& a, const NearNumber& b) {
    return {a.mantissa / b.mantissa, a.exponent - b.exponent};
  }
  friend NearNumber operator-(const NearNumber& a) { return {-a.mantissa, a.exponent}; }
  friend NearNumber operator+(const NearNumber& a, const NearNumber& b) {
    if (a.mantissa == 0) return b;
    if (b.mantissa == 0) return a;
    const bool swap = a.exponent < b.exponent;
    const NearNumber &more = swap ? b : a, &less = swap ? a : b;
    const long apart = more.exponent - less.exponent;
    if (apart > 100) return more;
    const auto moved = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - apart) << 52);
    int by = 0;
    const double sum = std::frexp(more.mantissa + less.mantissa * moved, &by);
    return {sum, more.exponent + by};
  }
  friend NearNumber operator-(const NearNumber& a, const NearNumber& b) { return a + -b; }
  friend bool operator<(const NearNumber& a, const NearNumber& b) { return (a - b).mantissa < 0; }
  friend NearNumber abs(const NearNumber& a) { return {std::abs(a.mantissa), a.exponent}; }
};

/// Off by at most 2^-52 of its size.
inline NearNumber near_number(mpz_srcptr value) {
  NearNumber near;
  near.mantissa = mpz_get_d_2exp(&near.exponent, value);
  return near;
}

inline NearNumber near_number(const boost::multiprecision::mpz_int& value) {
  return near_number(value.backend().data());
}

/// Off by at most 2^-50 of its size.
inline NearNumber near_number(mpq_srcptr value) {
  return near_number(mpq_numref(value)) / near_number(mpq_denref(value));
}

inline NearNumber near_number(const boost::multiprecision::mpq_rational& value) {
  return near_number(value.backend().data());
}

/// The sign of a - b where it is certain, else 0, given that both are off by at most 2^-49 of their size.
inline int certain_order(const NearNumber& a, const NearNumber& b) {
  const NearNumber difference = a - b;
  const NearNumber error =
      OPLUS_MUTANT("slide-believes-leading-digits",
                   "of two numbers of GMP with the same leading digits, roundings tell the smaller")
          ? NearNumber{}
          : NearNumber{1, -48} * (abs(a) + abs(b));
  return (error < difference) - (error < -difference);
}

}  // namespace oplus::slide
