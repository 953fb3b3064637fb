// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/definitions/rational.hpp"

namespace oplus {

/// The square root, rounded down or up to six digits or more; exact where that is a short decimal.
std::string rounded_root(const Rational& value, bool up);

/// Both: the root where it is a short decimal, else "between 1.41421 and 1.41422".
std::string rounded_roots(const Rational& least, const Rational& most);
inline std::string rounded_roots(const Rational& value) { return rounded_roots(value, value); }

}  // namespace oplus
