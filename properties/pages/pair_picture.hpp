// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/families/family.hpp"

namespace oplus {

/// Returns an SVG document: P, Q, and their convolution over the sum of the open regions.
std::string picture_of_pair(const Summands& pair);

}  // namespace oplus
