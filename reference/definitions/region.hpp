// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "reference/definitions/point.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

/// Returns all chains of a region: of each component the outer one, then its holes.
std::vector<Chain> chains(const Region& region);

/// Returns the edges of a chain, edge i leaving vertex i.
std::vector<Segment> edges(const Chain& chain);

/// Returns the edges of all chains of a region, in the order of `chains`.
std::vector<Segment> edges(const Region& region);

std::size_t vertex_count(const Region& region);

/// The index before or after i in a closed chain of the given length.
inline std::size_t previous(std::size_t i, std::size_t length) { return (i == 0 ? length : i) - 1; }
inline std::size_t next(std::size_t i, std::size_t length) { return i + 1 == length ? 0 : i + 1; }

/// Twice the signed area a chain encloses: positive if counterclockwise.
Rational twice_area(const Chain& chain);

/// Whether a chain turns right nowhere.
bool is_convex(const Chain& chain);

/// The area of a region, holes not counted.
Rational area(const Region& region);

/// Whether some component has a hole.
bool has_hole(const Region& region);

/// Calls visit(p) with each vertex, in the order of `chains`.
template <typename Visit>
void each_vertex(const Region& region, const Visit& visit) {
  for (const Component& component : region.components) {
    for (const Point& p : component.outer) visit(p);
    for (const Chain& hole : component.holes)
      for (const Point& p : hole) visit(p);
  }
}

/// Returns the region with `map(p)` in the place of each vertex p.
template <typename Map>
Region mapped(Region region, Map map) {
  for (Component& component : region.components) {
    for (Point& p : component.outer) p = map(p);
    for (Chain& hole : component.holes)
      for (Point& p : hole) p = map(p);
  }
  return region;
}

Chain translated(Chain chain, const Vector& by);
Region translated(Region region, const Vector& by);

/// Returns -R: each point p becomes -p. Turns by π, so orientations stay.
Region reflected(Region region);

/// The chain the other way round, from the same first vertex.
Chain turned(Chain chain);

/// The components of both. Valid where these are apart, or touch in points only.
Region together(Region a, const Region& b);

/// A region of one component without holes.
Region polygon(Chain outer);

Location locate(const Point& p, const Region& region);

}  // namespace oplus
