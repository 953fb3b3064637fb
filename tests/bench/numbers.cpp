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
  if (value == 0 || !std::isfinite(value)) return plain(value);
  const std::string rounded = printed("%.*e", 2, value);  // may have one more digit: 9.996 is 10.0
  const int magnitude = std::stoi(rounded.substr(rounded.find('e') + 1));
  return thousands_apart(printed("%.*f", std::max(0, 2 - magnitude), std::stod(rounded)));
}

std::string plain(double value) {
  return printed("%.*g", value == std::floor(value) ? 15 : 6, value);
}

std::string power_of_ten(double value) { return value == 0 ? "0" : printed("%.*e", 1, value); }

std::string with_thousands(std::size_t value) { return thousands_apart(std::to_string(value)); }

}  // namespace oplus
