// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "checked/oplus/oplus.hpp"

/// @file
/// Number types of other libraries, for <oplus/cgal.hpp> and <oplus/boost_geometry.hpp>. It includes
/// none of these libraries.
namespace oplus {

/// How numbers of type T become Rational, and back. Known are float, double and the built-in
/// integers; mpq_class and mpz_class; integers of Boost.Multiprecision, CGAL::Gmpz, CORE::BigInt;
/// any fraction with numerator() and denominator() of these, members or not; what has exact() of
/// these. To use a number type of your own, specialize this struct with the same three members.
template <typename T>
struct NumberConversion {
 private:
  static constexpr bool is_gmp = !std::is_arithmetic_v<T> && std::convertible_to<T, Rational>;
  static constexpr bool is_lazy = requires(const T& value) { value.exact(); };
  static constexpr bool is_cgal_integer = requires(const T& value) { value.mpz(); }
  || requires(const T& value) { value.get_mp(); };
  static constexpr bool is_boost_integer =
      std::numeric_limits<T>::is_integer && requires(const T& value) {
    value.str();
  };
  static constexpr bool is_large_integer = is_cgal_integer || is_boost_integer;
  static constexpr bool has_member_parts = !is_large_integer && requires(const T& value) {
    value.numerator();
    value.denominator();
  };
  static constexpr bool has_free_parts = !is_large_integer && requires(const T& value) {
    numerator(value);
    denominator(value);
  };

  /// What a fraction consists of, or what a lazy number is computed with.
  static auto inner(const T& value) {
    if constexpr (is_lazy)
      return value.exact();
    else if constexpr (has_member_parts)
      return value.numerator();
    else if constexpr (has_free_parts)
      return numerator(value);
  }
  using Inner = NumberConversion<decltype(inner(std::declval<const T&>()))>;

  static constexpr bool known() {
    if constexpr (std::is_arithmetic_v<T>)
      return std::is_integral_v<T> || sizeof(T) <= sizeof(double);
    else if constexpr (is_lazy || has_member_parts || has_free_parts)
      return Inner::is_rational;
    else
      return is_gmp || is_large_integer;
  }

 public:
  /// Whether each value of T is a rational number that can be converted.
  static constexpr bool is_rational = known();

  /// Returns the number, exactly. Throws InvalidInput for an infinity, for what is not a number and
  /// where a denominator is zero.
  static Rational exact(const T& value) {
    if constexpr (std::is_arithmetic_v<T> || is_gmp) {
      return Number(value).value();
    } else if constexpr (is_lazy) {
      return Inner::exact(value.exact());
    } else if constexpr (has_member_parts) {
      return quotient(Inner::exact(value.numerator()), Inner::exact(value.denominator()));
    } else if constexpr (has_free_parts) {
      return quotient(Inner::exact(numerator(value)), Inner::exact(denominator(value)));
    } else {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text << value;
      return Rational(text.str());
    }
  }

  /// Returns the number of type T: the same where T is exact, the nearest double, rounded to T, where
  /// it is floating-point. Throws std::domain_error where T, or the parts of a fraction, are integers
  /// that cannot hold it.
  static T nearest(const Rational& value) {
    if constexpr (std::is_floating_point_v<T>) {
      return static_cast<T>(to_double(value));
    } else if constexpr (std::same_as<T, Rational>) {
      return value;
    } else if constexpr (is_lazy) {
      return T(Inner::nearest(value));
    } else if constexpr (has_member_parts || has_free_parts) {
      return T(Inner::nearest(Rational(value.get_num())),
               Inner::nearest(Rational(value.get_den())));
    } else {
      return integer(value);
    }
  }

 private:
  static Rational quotient(const Rational& numerator, const Rational& denominator) {
    if (denominator == 0) return Number("1/0").value();  // which throws
    return numerator / denominator;
  }

  static T integer(const Rational& value) {
    bool fits = value.get_den() == 1;
    if constexpr (std::numeric_limits<T>::is_bounded)
      fits = fits && exact(std::numeric_limits<T>::lowest()) <= value &&
             value <= exact(std::numeric_limits<T>::max());
    if (!fits)
      throw std::domain_error("coordinate " + value.get_str() +
                              ": the integer type cannot hold it");
    if constexpr (std::is_integral_v<T>) {
      // Digit by digit: GMP's own conversion is to a long, which has 32 bits on some machines.
      T result = 0;
      for (const char c : value.get_num().get_str())
        if (c != '-') result = static_cast<T>(10 * result + (value < 0 ? '0' - c : c - '0'));
      return result;
    } else {
      return T(value.get_num().get_str());
    }
  }
};

}  // namespace oplus
