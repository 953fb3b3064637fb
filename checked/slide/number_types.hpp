// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace oplus::slide {

template <unsigned bits>
using FixedInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    bits, bits, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

/// The stages of integer arithmetic. Coordinates of a summand have at most `bits` bits, apart from
/// the sign. What is a skew or scalar product of sums and differences of four of them has less than
/// 2 bits + 5 and fits in Value; the sum of two products of two such fits in Product.
struct SmallNumbers {
  static constexpr std::size_t bits = 29;
  using Value = std::int64_t;
  __extension__ typedef __int128 Product;
};

struct WideNumbers {
  static constexpr std::size_t bits = 61;
  __extension__ typedef __int128 Value;
  using Product = FixedInteger<256>;
};

struct AnyNumbers {
  using Value = boost::multiprecision::mpz_int;
  using Product = Value;
};

/// Where a common denominator would be much longer than each coordinate, coordinates stay rationals.
/// Whatever is said of integers then holds for these.
struct RationalNumbers {
  using Value = boost::multiprecision::mpq_rational;
  using Product = Value;
};

template <typename Numbers>
constexpr bool is_small = std::is_same_v<Numbers, SmallNumbers>;

template <typename Numbers>
constexpr bool is_wide = std::is_same_v<Numbers, WideNumbers>;

template <typename Numbers>
constexpr bool has_fixed_width = is_small<Numbers> || is_wide<Numbers>;

template <typename Numbers>
constexpr bool is_rational = std::is_same_v<Numbers, RationalNumbers>;

template <typename Value>
constexpr bool is_of_gmp =
    std::is_same_v<Value, AnyNumbers::Value> || std::is_same_v<Value, RationalNumbers::Value>;

template <typename Value>
int sign_of(const Value& value) {
  return (value > 0) - (value < 0);
}

}  // namespace oplus::slide
