// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// A part of a region between two of its edges and the vertical lines through two of its vertices, the
/// left one really left of the right one. Numbers are those of `edges(region)`; a vertex has that of
/// the edge that leaves it.
struct Trapezoid {
  std::size_t below;
  std::size_t above;
  std::size_t left;
  std::size_t right;
};

/// Returns trapezoids whose interiors are disjoint and whose union is the region: from each vertex
/// walls go up and down inside the region, as far as the next edge. O(n log n), for at most two
/// trapezoids per vertex.
/// Requires: the region is valid (validity.hpp).
std::vector<Trapezoid> trapezoids(const Region& region);

}  // namespace oplus
