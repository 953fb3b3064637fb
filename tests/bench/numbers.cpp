// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace oplus {

namespace {

std::string printed(const char* format, int decimals, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, decimals, value);
  return text;
}

std::string thousands_apart(std::string digits) {
  const std::size_t begin = digits.starts_with('-') ? 1 : 0;
  const std::size_t end = std::min(digits.find('.'), digits.size());
  for (std::size_t at = end; at > begin + 3; at -= 3) digits.insert(at - 3, 1, ',');
  return digits;
}

}  // namespace

std::string three_digits(double value) {
  if (value == 0) return "0";
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double unit = std::pow(10, magnitude - 2);
  // Rounding may add a digit: 9.996 is 10.0.
  const double rounded = std::round(value / unit) * unit;
  const int digits = static_cast<int>(std::floor(std::log10(std::abs(rounded) * (1 + 1e-12))));
  return thousands_apart(printed("%.*f", std::max(0, 2 - digits), rounded));
}

std::string plain(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string power_of_ten(double value) { return value == 0 ? "0" : printed("%.*e", 1, value); }

std::string with_thousands(std::size_t value) { return thousands_apart(std::to_string(value)); }

}  // namespace oplus
