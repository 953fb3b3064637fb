// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/numbers.hpp"

#include "checked/cli/usage_error.hpp"
#include "reference/io/number.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

Rational number(const std::string& option, const std::string& text) {
  NumberFault fault;
  const std::optional<Rational> value = parse_number(text, fault);
  if (!value) throw UsageError(option + ": " + fault.wrong + "; expected " + fault.expected);
  return *value;
}

Rational distance_number(const std::string& option, const std::string& text) {
  const Rational value = number(option, text);
  if (sgn(value) < 0)
    throw UsageError(option + " takes a distance, not the negative number " + quote(text));
  return value;
}

Rational positive_number(const std::string& option, const std::string& what,
                         const std::string& text) {
  const Rational value = number(option, text);
  if (sgn(value) <= 0) throw UsageError(option + " takes " + what + " above 0, not " + quote(text));
  return value;
}

Point pair_of_numbers(const std::string& option, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw UsageError(option + ": " + quote(text) +
                     " is not two numbers; expected them with a comma between them, as in 1,0.5");
  return {number(option, text.substr(0, comma)), number(option, text.substr(comma + 1))};
}

std::string rounded_root(const Rational& value, bool up) {
  if (sign(value) == 0) return "0";
  mpz_class scale = 1;
  for (int digits = 0;; ++digits, scale *= 10) {
    const Rational scaled = value * Rational(scale) * Rational(scale);
    const mpz_class whole = scaled.get_num() / scaled.get_den();
    const mpz_class floor = sqrt(whole);
    const bool exact = Rational(floor) * Rational(floor) == scaled;
    if (!exact && floor < 100000 && digits < most_digits) continue;
    return to_string(Rational(floor + (up && !exact ? 1 : 0)) / Rational(scale), digits);
  }
}

std::string rounded_roots(const Rational& least, const Rational& most) {
  const std::string low = rounded_root(least, false), high = rounded_root(most, true);
  return low == high ? low : "between " + low + " and " + high;
}

}  // namespace oplus
