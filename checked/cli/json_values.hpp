// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "checked/statistics.hpp"
#include "reference/definitions/point.hpp"

namespace oplus {

// How the program says things in JSON: docs/json.md.
using Json = nlohmann::ordered_json;

/// ["1/3", "2.5"], exact.
Json json(const Point& p);

/// A count is an integer, seconds a number of six decimals, a value the text of the exact one.
Json json(const Quantity& quantity);

/// An object: "outer chains" is "outer_chains".
Json json(const Statistics& statistics);

}  // namespace oplus
