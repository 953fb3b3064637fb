// SPDX-License-Identifier: MIT
#include "reference/io/number.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>

#include "reference/definitions/mutant.hpp"
#include "reference/io/power_of_ten.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the digits at the front of a text.
std::string_view take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

/// Takes a sign, if there is one; returns whether it is a minus.
bool take_sign(std::string_view& text) {
  const bool has_sign = !text.empty() && (text[0] == '-' || text[0] == '+');
  const bool is_minus = has_sign && text[0] == '-';
  if (has_sign) text.remove_prefix(1);
  return is_minus;
}

bool take_letter(std::string_view& text, std::string_view letters) {
  const bool found = !text.empty() && letters.find(text[0]) != std::string_view::npos;
  if (found) text.remove_prefix(1);
  return found;
}

/// Whether an integer holds every number of this many digits.
bool is_short(std::size_t digits) { return digits <= std::numeric_limits<unsigned long>::digits10; }

/// Puts a decimal with these digits before and behind the point there, in lowest terms: most coordinates
/// are so short, and GMP would take longer. Requires: is_short(all of them).
void put_short(bool is_negative, std::string_view whole, std::string_view decimals,
               Rational& value) {
  unsigned long numerator = 0;
  for (const char digit : whole) numerator = 10 * numerator + static_cast<unsigned>(digit - '0');
  for (const char digit : decimals) numerator = 10 * numerator + static_cast<unsigned>(digit - '0');
  unsigned long denominator = 1;
  for (std::size_t twos = decimals.size(); twos > 0; --twos) {
    if (numerator % 2 == 0)
      numerator /= 2;
    else
      denominator *= 2;
  }
  for (std::size_t fives = decimals.size(); fives > 0; --fives) {
    if (numerator % 5 == 0)
      numerator /= 5;
    else
      denominator *= 5;
  }
  mpq_set_ui(value.get_mpq_t(), numerator, denominator);
  if (is_negative) mpq_neg(value.get_mpq_t(), value.get_mpq_t());
}

mpz_class integer(std::string_view digits) { return mpz_class(std::string(digits), 10); }

/// The value of an exponent's digits, or none if it is beyond the largest.
std::optional<int> exponent_value(std::string_view digits) {
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || value > largest_exponent) return std::nullopt;
  return value;
}

bool is_nan_or_infinity(std::string_view unsigned_text) {
  std::string lower(unsigned_text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

}  // namespace

bool put_number(std::string_view text, Rational& value, NumberFault& fault) {
  const auto refused = [&](const std::string& wrong, const std::string& expected) {
    fault = {quote(text) + ' ' + wrong, expected};
    return false;
  };
  const auto not_a_number = [&] {
    return refused("is not a number", "an integer, a decimal or a fraction p/q");
  };
  std::string_view rest = text;
  const bool is_negative = take_sign(rest);
  const std::string_view whole = take_digits(rest);
  if (whole.empty() && is_nan_or_infinity(rest)) return refused("is not finite", "a finite number");
  if (take_letter(rest, "/")) {
    const std::string_view denominator = take_digits(rest);
    if (whole.empty() || denominator.empty() || !rest.empty()) return not_a_number();
    Rational fraction(integer(whole), integer(denominator));
    if (fraction.get_den() == 0 &&
        !OPLUS_MUTANT("denominators-may-be-zero",
                      "a fraction with the denominator 0 is not refused"))
      return refused("has the denominator 0", "a fraction p/q with q > 0");
    fraction.canonicalize();
    value = is_negative ? Rational(-fraction) : fraction;
    return true;
  }

  const std::string_view decimals = take_letter(rest, ".") ? take_digits(rest) : "";
  if (whole.empty() && decimals.empty()) return not_a_number();
  int exponent = 0;
  if (take_letter(rest, "eE")) {
    const bool is_negative_exponent = take_sign(rest);
    const std::string_view digits = take_digits(rest);
    if (digits.empty() || !rest.empty()) return not_a_number();
    const std::optional<int> size = exponent_value(digits);
    if (!size) {
      const std::string limit = std::to_string(largest_exponent);
      return refused("has too large an exponent", "an exponent from -" + limit + " to " + limit);
    }
    exponent = is_negative_exponent ? -*size : *size;
  }
  if (!rest.empty()) return not_a_number();

  if (exponent == 0 && is_short(whole.size() + decimals.size())) {
    put_short(is_negative, whole, decimals, value);
    return true;
  }
  std::string digits(whole);
  digits += decimals;
  Rational decimal(integer(digits), power_of_ten(decimals.size()));
  decimal.canonicalize();
  const Rational scale(power_of_ten(static_cast<std::size_t>(std::abs(exponent))));
  if (exponent < 0)
    decimal /= scale;
  else
    decimal *= scale;
  value = is_negative ? Rational(-decimal) : decimal;
  return true;
}

std::optional<Rational> parse_number(std::string_view text, NumberFault& fault) {
  Rational value;
  if (!put_number(text, value, fault)) return std::nullopt;
  return value;
}

}  // namespace oplus
