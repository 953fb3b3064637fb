// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/rounded_root.hpp"

#include "reference/io/writing.hpp"

namespace oplus {

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
