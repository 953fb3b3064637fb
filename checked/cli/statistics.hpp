// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// Names and values, in the order in which they are printed.
using Statistics = std::vector<std::pair<std::string, std::string>>;

/// How many parts of each kind the sum has, and its area: exact, but rounded, and said so, where
/// that would take a line of its own.
Statistics statistics_of(const MinkowskiSum& sum);

}  // namespace oplus
