// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/definitions/rational.hpp"

namespace oplus {

/// The number that an option was given, exactly: an integer, a decimal or a fraction. Throws UsageError,
/// which names the option.
Rational number(const std::string& option, const std::string& text);

/// The same of a distance, which is not negative.
Rational distance_number(const std::string& option, const std::string& text);

/// The same of a number above 0; `what` is how the message calls it: "a step".
Rational positive_number(const std::string& option, const std::string& what,
                         const std::string& text);

/// The same of two numbers with a comma between them. Throws UsageError, likewise.
Point pair_of_numbers(const std::string& option, const std::string& text);

/// The square root, rounded down or up to six digits or more; exact where that is a short decimal.
std::string rounded_root(const Rational& value, bool up);

/// Both: the root where it is a short decimal, else "between 1.41421 and 1.41422".
std::string rounded_roots(const Rational& least, const Rational& most);
inline std::string rounded_roots(const Rational& value) { return rounded_roots(value, value); }

}  // namespace oplus
