// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus::certificates {

// What is outside of a region, within a square around the origin. The checker makes the same chains, so that vertices
// have the same numbers.

/// The largest coordinate of these regions, without a sign, or 1 if that is larger.
Rational frame_size(const std::vector<const Region*>& regions);

/// The square whose coordinates are up to k.
Chain square(const Rational& k);

/// The square's chain, then those of the region, turned, as holes. Requires: no coordinate is k or larger.
Region complement_in_square(const Rational& k, const Region& region);

}  // namespace oplus::certificates
