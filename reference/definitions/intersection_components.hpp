// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "reference/definitions/region.hpp"

namespace oplus {

/// The topology of an open set of the plane: its connected components and, of their complement, the
/// bounded ones.
struct ComponentsAndHoles {
  std::size_t components;
  std::size_t holes;

  int euler_characteristic() const {
    return static_cast<int>(components) - static_cast<int>(holes);
  }
  friend bool operator==(const ComponentsAndHoles&, const ComponentsAndHoles&) = default;
};

/// CCC(x) (thesis, Definition 4.2.9) with holes: the topology of the intersection of the interiors
/// of P and -Q+x. Parts that touch in points only are several components; a hole that touches the
/// outside does not count. From the arrangement of both boundaries.
/// Requires: P and Q are valid; x is on no segment of the vertex-edge sum, so that no vertex of
/// either is on the other's boundary and edges cross properly or not at all.
ComponentsAndHoles intersection_components(const Region& p, const Region& q, const Point& x);

}  // namespace oplus
