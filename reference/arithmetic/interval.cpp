// SPDX-License-Identifier: MIT
#include "reference/arithmetic/interval.hpp"

namespace oplus {

namespace {

/// Whether a number is a double: its denominator is a power of two that a double may have, and its
/// numerator has at most 53 significant bits and is not too large.
bool is_double(const Rational& value) {
  const mpz_srcptr numerator = value.get_num_mpz_t();
  const mpz_srcptr denominator = value.get_den_mpz_t();
  if (mpz_sgn(numerator) == 0) return true;
  const std::size_t size = mpz_sizeinbase(numerator, 2);
  const std::size_t exponent = mpz_sizeinbase(denominator, 2) - 1;
  return mpz_scan1(denominator, 0) == exponent && exponent <= 1074 && size <= exponent + 1024 &&
         size - mpz_scan1(numerator, 0) <= 53;
}

}  // namespace

Interval interval(const Rational& value) {
  if (mpz_cmp_ui(value.get_den_mpz_t(), 1) == 0 && mpz_fits_slong_p(value.get_num_mpz_t()) != 0) {
    const std::int64_t whole = mpz_get_si(value.get_num_mpz_t());
    constexpr std::int64_t largest = std::int64_t{1} << 53;
    if (-largest <= whole && whole <= largest)
      return {static_cast<double>(whole), static_cast<double>(whole)};
  }
  const double near = value.get_d();  // rounded towards zero
  if (is_double(value)) return {near, near};
  const double size = std::min(std::abs(near), DBL_MAX);
  const Interval of_size{size, outward(size, size).high};
  return sgn(value) < 0 ? -of_size : of_size;
}

std::optional<int> orientation_of_intervals(const IntervalPoint& a, const IntervalPoint& b,
                                            const IntervalPoint& c) {
  return sign(cross(b - a, c - a));
}

}  // namespace oplus
