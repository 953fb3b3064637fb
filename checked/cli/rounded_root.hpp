// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/definitions/rational.hpp"

namespace oplus {

/// The square root, rounded down or up to six digits or more; exact where that is a short decimal.
std::string rounded_root(const Rational& value, bool up);

}  // namespace oplus
