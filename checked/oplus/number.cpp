// SPDX-License-Identifier: MIT
#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <utility>

#include "checked/arithmetic/set_integer.hpp"
#include "checked/oplus/oplus.hpp"
#include "reference/io/number.hpp"

namespace oplus {

namespace {

[[noreturn]] void refuse(const std::string& wrong, const std::string& expected) {
  throw InvalidInput({"coordinate", 0, 0}, wrong, expected);
}

}  // namespace

Number::Exact Number::from_double(double value) {
  if (!std::isfinite(value)) refuse("the double is infinite or not a number", "a finite one");
  return {Rational(value)};
}

Number::Exact Number::from_integer(bool is_negative, std::uint64_t bits) {
  const std::uint64_t size = is_negative ? 0 - bits : bits;
  const Integer128 value = size;
  Rational result;
  set_integer(result.get_num_mpz_t(), is_negative ? -value : value);
  return {std::move(result)};
}

Number::Exact Number::from_rational(Rational value) {
  if (value.get_den() == 0) refuse("the denominator is zero", "a rational number");
  if (value.get_den() != 1) value.canonicalize();
  return {std::move(value)};
}

Number::Exact Number::from_text(std::string_view text) {
  NumberFault fault;
  std::optional<Rational> value = parse_number(text, fault);
  if (!value) refuse(fault.wrong, fault.expected);
  return {std::move(*value)};
}

double to_double(const Rational& value) {
  // The quotient of two doubles is the nearest one.
  constexpr std::size_t exact = DBL_MANT_DIG;
  if (mpz_sizeinbase(value.get_num_mpz_t(), 2) <= exact &&
      mpz_sizeinbase(value.get_den_mpz_t(), 2) <= exact)
    return value.get_num().get_d() / value.get_den().get_d();
  const Rational size = abs(value);
  // GMP rounds towards zero and does not say what it does beyond the largest double.
  const double below = size > DBL_MAX ? DBL_MAX : size.get_d();
  const double above = std::nextafter(below, std::numeric_limits<double>::infinity());
  // Beyond the largest double, 2^1024 is the next number that the rule of rounding knows.
  const Rational next = std::isinf(above) ? Rational(mpz_class(1) << DBL_MAX_EXP) : Rational(above);
  const int nearer = cmp(Rational(2 * size), Rational(Rational(below) + next));
  const bool is_even = (std::bit_cast<std::uint64_t>(below) & 1) == 0;
  const double rounded = nearer < 0 || (nearer == 0 && is_even) ? below : above;
  return sgn(value) < 0 ? -rounded : rounded;
}

std::array<double, 2> to_double(const Point& point) {
  return {to_double(point.x), to_double(point.y)};
}

}  // namespace oplus
