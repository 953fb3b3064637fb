// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// The regions of a file that has one a line, in any form that read_region() takes; blank lines are left out.
/// Throws InvalidInput, also where there is none.
std::vector<Region> read_region_lines(const std::string& path);

}  // namespace oplus
