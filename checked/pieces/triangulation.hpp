// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "checked/pieces/place.hpp"
#include "reference/chains/near_point.hpp"
#include "reference/chains/plane_sweep.hpp"

namespace oplus::pieces {

/// A vertex of the region that lies inside one of its edges, where chains touch.
struct PointInEdge {
  std::uint32_t edge;  ///< the number of its source in the order of `chains`
  Point point;

  friend bool operator==(const PointInEdge&, const PointInEdge&) = default;
};

/// Triangles whose interiors are disjoint and whose union is a region. Edge 3 t + k leaves corner k of
/// triangle t; corners are counterclockwise.
struct Triangulation {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<std::uint32_t>
      sources;                       ///< of edges, vertices of the region; of equal ones the first
  std::vector<std::uint32_t> twins;  ///< diagonals the other way; none: an edge of the region
  std::vector<PointInEdge> points;   ///< by edges, along each in order

  static std::uint32_t next(std::uint32_t e) { return e % 3 == 2 ? e - 2 : e + 1; }
  static std::uint32_t previous(std::uint32_t e) { return e % 3 == 0 ? e + 2 : e - 1; }
};

/// The constrained Delaunay triangulation, where doubles show what that is. O(n log n) in practice: a sweep,
/// and then diagonals are flipped.
/// Requires: no two edges cross or overlap, each has the region to its left only, none is a point. `vertices` and
/// `places` are the points of the boundary.
Triangulation triangulation(const SweptEdges& boundary, std::span<const NearPoint> vertices,
                            std::span<const Place> places);

}  // namespace oplus::pieces
