// SPDX-License-Identifier: MIT
#include "reference/arithmetic/interval.hpp"

#include <cstdlib>

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

/// The sign of a b - c d, by integers: the std::fma of MinGW-w64 10 rounds twice. Requires: the doubles are
/// finite, their products are not 0, and differ by less than a thousandth.
int sign_of_small_difference(double a, double b, double c, double d) {
  __extension__ using Product = __int128;
  int exponent = 0;  // of a b, less that of c d
  const auto mantissa = [&](double value, int sign) -> Product {
    int of_value = 0;
    const double part = std::frexp(value, &of_value);
    exponent += sign * of_value;
    return static_cast<std::int64_t>(part * 0x1p53);
  };
  Product left = mantissa(a, 1) * mantissa(b, 1), right = mantissa(c, -1) * mantissa(d, -1);
  (exponent > 0 ? left : right) <<= std::abs(exponent);  // by 2 at most
  return (left > right) - (left < right);
}

}  // namespace

Interval interval(const Rational& value) {
  const mpz_srcptr numerator = value.get_num_mpz_t(), denominator = value.get_den_mpz_t();
  constexpr std::int64_t largest = std::int64_t{1} << 53;
  if (mpz_fits_slong_p(numerator) != 0 && mpz_fits_slong_p(denominator) != 0) {
    const std::int64_t whole = mpz_get_si(numerator), parts = mpz_get_si(denominator);
    if (-largest <= whole && whole <= largest && parts <= largest) {
      const auto n = static_cast<double>(whole), d = static_cast<double>(parts);
      const double near = n / d;
      if ((parts & (parts - 1)) == 0) return {near, near};
      // In lowest terms it is no double, and the remainder tells on which side of the quotient it is.
      const Interval both = outward(near, near);
      return sign_of_small_difference(near, d, n, 1) > 0 ? Interval{both.low, near}
                                                         : Interval{near, both.high};
    }
  }
  const double near = value.get_d();  // rounded towards zero
  if (is_double(value)) return {near, near};
  const double size = std::min(std::abs(near), DBL_MAX);
  const Interval of_size{size, outward(size, size).high};
  return sgn(value) < 0 ? -of_size : of_size;
}

std::optional<int> sign_of_cross(const IntervalPoint& u, const IntervalPoint& v) {
  if (is_exact(u.x) && is_exact(u.y) && is_exact(v.x) && is_exact(v.y)) {
    // Rounding is monotonic: where rounded products differ, the products differ in the same way.
    const double left = u.x.low * v.y.low, right = u.y.low * v.x.low;
    if (left != right) return left > right ? 1 : -1;
    if (left == 0 && (u.x.low == 0 || v.y.low == 0) && (u.y.low == 0 || v.x.low == 0)) return 0;
    if (std::abs(left) > 0x1p-900 && std::abs(left) <= DBL_MAX)
      return sign_of_small_difference(u.x.low, v.y.low, u.y.low, v.x.low);
  }
  return sign(cross(u, v));
}

std::optional<int> orientation_of_intervals(const IntervalPoint& a, const IntervalPoint& b,
                                            const IntervalPoint& c) {
  return sign_of_cross(b - a, c - a);
}

}  // namespace oplus
