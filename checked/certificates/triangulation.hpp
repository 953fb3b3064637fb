// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus::certificates {

/// A vertex of the region that lies inside one of its edges, where chains touch.
struct PointInEdge {
  std::uint32_t edge;  ///< the number of its source in the order of `chains`
  Point point;

  friend bool operator==(const PointInEdge&, const PointInEdge&) = default;
};

struct Triangle {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::array<std::uint32_t, 3> corners;  ///< counterclockwise; of equal vertices the first
  std::array<std::uint32_t, 3>
      across;  ///< beyond the edge that leaves the corner; none: an edge of the region
};

/// Triangles whose interiors are disjoint and whose union is a region. Their corners are its vertices,
/// numbered in the order of `chains`.
struct Triangulation {
  std::vector<Triangle> triangles;
  std::vector<PointInEdge> points;  ///< by edges, along each in order
};

/// The constrained Delaunay triangulation. O(n log n) in practice.
/// Requires: no two edges cross or overlap, each has the region to its left only, none is a point.
Triangulation triangulation(const Region& region);

}  // namespace oplus::certificates
