// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// A point in which chains of a region touch.
struct TouchingExteriors {
  Point at;
  int exteriors;  ///< at least 1
};

/// Returns the points in which chains of a valid region touch, and into how many parts the exterior
/// around each is divided: two where a hole touches its outer chain, one where two components
/// touch.
std::vector<TouchingExteriors> touching_exteriors(const Region& region);

}  // namespace oplus
