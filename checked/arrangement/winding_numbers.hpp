// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "checked/arrangement/convolution_arrangement.hpp"

namespace oplus {

/// The winding number of each face with respect to the arrangement's segments, by breadth-first
/// traversal from the unbounded face, crossing one edge at a time (thesis, Section 6.2.1, after
/// Wein; Definition 4.2.3). Linear in the size of the arrangement.
/// Requires: the segments form closed cycles.
std::vector<int> winding_numbers(const ConvolutionArrangement& arrangement);

}  // namespace oplus
