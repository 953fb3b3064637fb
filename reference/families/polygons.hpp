// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "reference/definitions/region.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// Polygons of the thesis's random families (Section 6.1.3), on integers: one counterclockwise
/// chain of exactly n vertices. Require: n >= 3.

/// Vertices on a circle about the origin, of radius 10^5 to 10^6, or n² where the grid would be too
/// coarse for that number of vertices. No vertex is inside a straight line.
Region convex_polygon(Random& random, std::size_t n);

/// Star-shaped about the origin: random directions, each with a random radius up to 10^6.
Region star_polygon(Random& random, std::size_t n);

/// Random points in a square of side 10^6, the Delaunay triangulation of n + ⌈n/10⌉ of them, from
/// whose boundary triangles are taken away until it has n vertices.
Region simple_polygon(Random& random, std::size_t n);

/// Not of the thesis, a polygon like a coastline: a triangle whose longest edge gets a vertex to
/// either side of its middle, again and again, wherever the boundary stays simple. Bays in bays, on
/// integers from 0 to 2^20.
Region coast_polygon(Random& random, std::size_t n);

/// n teeth upwards on a flat back, 2n + 3 vertices; from left to right the teeth come last to first.
Region comb_polygon(Random& random, std::size_t n);

/// The convex hull of `points` random points with coordinates 0 to side - 1. Vertices at most
/// `points`. Requires: points >= 3, side >= 2.
Region convex_grid_polygon(Random& random, std::size_t points, int side);

}  // namespace oplus
