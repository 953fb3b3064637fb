// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/definitions/values.hpp"

namespace oplus {

// Lines for reports, in WKT where that can hold the value.

/// An unbounded region is in the form of .dat.
std::string in_words(const Region& region);

/// A sum that is no region, or is unbounded, is listed by its chains, edges and points.
std::string in_words(const PlanarSet& sum);

}  // namespace oplus
