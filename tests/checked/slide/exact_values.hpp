// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "checked/operations/image.hpp"
#include "checked/slide/exact_point.hpp"
#include "checked/slide/integer_summands.hpp"
#include "reference/definitions/segment.hpp"
#include "reference/families/random.hpp"

namespace oplus::slide {

// What the stages of arithmetic compute, as rationals that know nothing of stages.

using AllNumbers = testing::Types<SmallNumbers, WideNumbers, AnyNumbers, RationalNumbers>;

template <typename Value>
mpz_class integer(const Value& value) {
  if constexpr (std::is_same_v<Value, std::int64_t>)
    return mpz_class(std::to_string(value));
  else if constexpr (std::is_same_v<Value, WideNumbers::Value>)
    return rational(value).get_num();
  else
    return mpz_class(value.str());
}

/// The other way round. Requires: it fits.
template <typename Numbers>
typename Numbers::Value value(const mpz_class& integer) {
  if constexpr (is_small<Numbers>)
    return std::stoll(integer.get_str());
  else if constexpr (is_wide<Numbers>)
    return static_cast<WideNumbers::Value>(FixedInteger<256>(integer.get_str()));
  else
    return typename Numbers::Value(integer.get_str());
}

template <typename Numbers>
Fraction<Numbers> fraction(const mpz_class& n, const mpz_class& d) {
  return {value<Numbers>(n), value<Numbers>(d)};
}

template <typename Numbers>
Rational place_of(const Fraction<Numbers>& fraction) {
  return Rational(integer(fraction.numerator())) / integer(fraction.denominator());
}

/// An upper bound for the number of bits of a fraction's numbers in tests.
template <typename Numbers>
constexpr unsigned bits = is_small<Numbers>  ? 62
                          : is_wide<Numbers> ? 126
                                             : 3000;

inline mpz_class odd_number(Random& random, unsigned of_bits) {
  mpz_class number = 1;
  while (mpz_sizeinbase(number.get_mpz_t(), 2) < of_bits)
    number = (number << 16) + uniform(random, 1, 0xffff);
  return (number >> static_cast<mp_bitcnt_t>(mpz_sizeinbase(number.get_mpz_t(), 2) - of_bits)) | 1;
}

/// From one point to another. Requires: integer coordinates.
template <typename Numbers>
IntegerSegment<Numbers> integer_segment(const Segment& s) {
  const Vector d = direction_of(s);
  return {{value<Numbers>(s.source.x.get_num()), value<Numbers>(s.source.y.get_num())},
          {value<Numbers>(d.x.get_num()), value<Numbers>(d.y.get_num())}};
}

/// 2 to a power, which may be negative.
inline Rational power_of_two(int exponent) {
  const mpz_class power = mpz_class(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

inline AffineMap quarter_turns(int times) {
  constexpr int cosine[] = {1, 0, -1, 0};
  const int sine = cosine[(times + 3) % 4];
  return {cosine[times % 4], -sine, sine, cosine[times % 4]};
}

}  // namespace oplus::slide
