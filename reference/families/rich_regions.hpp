// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <utility>

#include "reference/definitions/region.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// Regions on small grids, chains of 3 to `most` vertices, valid, that touch themselves often.
/// Require: most >= 3.

/// One component without holes.
Region plain_region(Random& random, std::size_t most);

/// One component with one to three holes; they may touch each other and the outer chain in points.
Region holed_region(Random& random, std::size_t most);

/// Two to four components, with and without holes; they may touch in points, or lie in a hole.
Region scattered_region(Random& random, std::size_t most);

/// Unit squares of the grid, named by their lower left corners.
using Cells = std::set<std::pair<int, int>>;

/// Returns the union of the cells: components and holes as they come, touching each other where
/// two cells have only a corner in common. No vertex is inside a straight line.
Region region_of_cells(const Cells& cells);

}  // namespace oplus
