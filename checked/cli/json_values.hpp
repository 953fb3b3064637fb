// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "checked/cli/statistics.hpp"
#include "reference/definitions/point.hpp"

namespace oplus {

// How the program says things in JSON: docs/json.md.
using Json = nlohmann::ordered_json;

/// ["1/3", "2.5"], exact.
Json json(const Point& p);

/// An object: "outer chains" is "outer_chains", a count an integer, seconds a number.
Json json(const Statistics& statistics);

/// The same of a sum, its area exact however long that is.
Json json_statistics_of(const MinkowskiSum& sum);

}  // namespace oplus
