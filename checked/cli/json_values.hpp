// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "checked/statistics.hpp"
#include "reference/definitions/planar_set.hpp"
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

/// How many parts of each kind the sum has, and its area.
Statistics statistics_of(const PlanarSet& sum);

/// A count; seconds, rounded as in JSON; a value exactly, or rounded and marked so where it is long.
std::string in_text(const Quantity& quantity);

}  // namespace oplus
