// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace oplus {

/// Three significant digits, thousands separated: "0.0123", "1.20", "4,560".
std::string three_digits(double value);

/// Integers exactly, others with six digits: "60", "0.25".
std::string plain(double value);

/// "-1.2e-06"; "0" only for zero.
std::string power_of_ten(double value);

std::string with_thousands(std::size_t value);

}  // namespace oplus
