// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// Segments on which all points lie that are in the interior of the closed sum and not in the open
/// one, with the boundary of both: the convolution, and the contacts of vertices in which chains touch.
std::vector<Segment> exceptional_places(const Region& p, const Region& q);

}  // namespace oplus
