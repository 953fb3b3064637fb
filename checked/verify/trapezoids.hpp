// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// A part of a region between two of its edges and the vertical lines through two of its vertices,
/// the left one really left of the right one. A vertex is named by an edge that starts there.
struct Trapezoid {
  std::size_t below;
  std::size_t above;
  std::size_t left;
  std::size_t right;
};

/// Returns trapezoids whose interiors are disjoint and whose union is the region with these edges,
/// by a sweep from left to right. From each vertex walls go up and down inside the region, as far as
/// the next edge. O(n log n); at most three trapezoids per vertex.
/// Requires: the edges are those of a valid region (edges(region)).
std::vector<Trapezoid> trapezoids(const std::vector<Segment>& edges);

}  // namespace oplus
