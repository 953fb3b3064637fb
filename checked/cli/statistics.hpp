// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "checked/statistics.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// How many parts of each kind the sum has, and its area.
Statistics statistics_of(const PlanarSet& sum);

/// A count; seconds, to six decimals; a value exactly, or rounded and marked so where it is long.
std::string in_text(const Quantity& quantity);

}  // namespace oplus
