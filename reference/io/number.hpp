// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reference/definitions/rational.hpp"

namespace oplus {

/// Larger exponents are refused: a few bytes would stand for a number that fills the memory.
inline constexpr int largest_exponent = 4096;

/// Why a text is no number, and what would be.
struct NumberFault {
  std::string wrong;
  std::string expected;
};

/// Returns the number that a text denotes, exactly: an integer, a decimal, with or without an
/// exponent, or a fraction p/q of integers, q without a sign; or none, and says why in `fault`.
std::optional<Rational> parse_number(std::string_view text, NumberFault& fault);

}  // namespace oplus
