// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <utility>

#include "reference/definitions/region.hpp"

namespace oplus {

/// Unit squares of the grid, named by their lower left corners.
using Cells = std::set<std::pair<int, int>>;

/// Returns the union of the cells: components and holes as they come, touching each other where
/// two cells have only a corner in common. No vertex is inside a straight line.
Region region_of_cells(const Cells& cells);

}  // namespace oplus
