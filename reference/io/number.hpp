// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reference/definitions/rational.hpp"

namespace oplus {

/// Larger exponents are refused: a number of a few bytes could fill the memory.
inline constexpr int largest_exponent = 4096;

/// Why a text is not a number, and what was expected.
struct NumberFault {
  std::string wrong;
  std::string expected;
};

/// Returns the number that a text denotes, exactly: an integer, a decimal, with or without an
/// exponent, or a fraction p/q of integers, q without a sign. Returns nothing for an invalid text, and
/// the reason in `fault`.
std::optional<Rational> parse_number(std::string_view text, NumberFault& fault);

/// The same, put into `value`, which saves allocations; returns whether the text is valid. Else `value`
/// is as before.
bool put_number(std::string_view text, Rational& value, NumberFault& fault);

}  // namespace oplus
