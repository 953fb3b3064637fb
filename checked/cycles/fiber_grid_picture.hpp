// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "checked/cycles/fiber_grid.hpp"

namespace oplus {

/// Returns an SVG document: P's index to the right, Q's upwards, edges as arrows in the colours of
/// their cycles, starts of cycles ringed. The first column and row are drawn again, lighter, after the
/// last, where the grid closes. Same grid, same bytes.
std::string svg(const FiberGrid& grid);

}  // namespace oplus
