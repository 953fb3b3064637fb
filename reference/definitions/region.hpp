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

/// Returns the edges of a chain, cut at those of the points that lie inside them.
std::vector<Segment> cut_edges(const Chain& chain, const std::vector<Point>& at);

/// Returns the edges of all chains of a region, in the order of `chains`.
std::vector<Segment> edges(const Region& region);

std::size_t vertex_count(const Region& region);

/// The index before or after i in a closed chain of the given length.
inline std::size_t previous(std::size_t i, std::size_t length) { return (i == 0 ? length : i) - 1; }
inline std::size_t next(std::size_t i, std::size_t length) { return i + 1 == length ? 0 : i + 1; }

/// Twice the signed area a chain encloses: positive if counterclockwise.
Rational twice_area(const Chain& chain);

/// The area of a region, holes not counted.
Rational area(const Region& region);

/// Whether some component has a hole.
bool has_hole(const Region& region);

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

/// Returns the points in which different chains of a valid region touch, sorted.
std::vector<Point> touching_points(const Region& region);

/// Returns the edges of each chain, cut where another chain touches it: around each point inside
/// such a piece, the region fills exactly the half disk to its left.
std::vector<std::vector<Segment>> pieces_by_chain(const Region& region);

/// The same of all chains together.
std::vector<Segment> boundary_pieces(const Region& region);

/// A region of one component without holes.
Region polygon(Chain outer);

Location locate(const Point& p, const Region& region);

}  // namespace oplus
