// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <type_traits>

/// What the sums along lines are computed in: 64 bits, 128 bits or GMP (sums_along_lines.cpp says when).
namespace oplus::along_lines {

__extension__ typedef __int128 Int128;

inline double as_double(std::int64_t value) { return static_cast<double>(value); }
inline double as_double(Int128 value) { return static_cast<double>(value); }
inline double as_double(const mpz_class& value) { return value.get_d(); }

inline mpz_class as_mpz(std::int64_t value) { return static_cast<long>(value); }
inline mpz_class as_mpz(Int128 value) {
  constexpr Int128 low_part = Int128(1) << 62;
  return (mpz_class(static_cast<long>(value / low_part)) << 62) +
         static_cast<long>(value % low_part);
}
inline const mpz_class& as_mpz(const mpz_class& value) { return value; }

/// The same value. Requires: To can hold it.
template <typename To, typename From>
To number(const From& value) {
  if constexpr (std::is_same_v<To, From>) {
    return value;
  } else if constexpr (std::is_same_v<To, mpz_class>) {
    return as_mpz(value);
  } else if constexpr (std::is_same_v<From, mpz_class>) {
    if (std::is_same_v<To, std::int64_t> || value.fits_slong_p()) return value.get_si();
    constexpr unsigned low_part = 62;
    const mpz_class high = value >> low_part;
    return (To(high.get_si()) << low_part) + mpz_class(value - (high << low_part)).get_si();
  } else {
    return static_cast<To>(value);
  }
}

template <typename T>
int sign_of(const T& value) {
  return (value > 0) - (value < 0);
}

/// The sign of a number that doubles say is near to another; 0 where they do not know.
inline int certain_sign(double near, double error) { return (near > error) - (near < -error); }

template <typename T>
struct Vec {
  T x, y;

  friend Vec operator+(const Vec& a, const Vec& b) { return {T(a.x + b.x), T(a.y + b.y)}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {T(a.x - b.x), T(a.y - b.y)}; }
};

template <typename T>
T skew(const Vec<T>& a, const Vec<T>& b) {
  return T(a.x * b.y - a.y * b.x);
}
template <typename T>
T scalar(const Vec<T>& a, const Vec<T>& b) {
  return T(a.x * b.x + a.y * b.y);
}

}  // namespace oplus::along_lines
