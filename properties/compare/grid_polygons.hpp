// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "reference/families/lattice_polygon.hpp"

#include "reference/chains/region_of.hpp"

namespace oplus {

/// A counterclockwise simple polygon on a grid, moved to its lower left corner: its least x and its
/// least y are 0. It starts at its lexicographically smallest vertex. Vertices inside a straight line
/// are allowed: they are degenerate input, which is the subject.
using GridPolygon = std::vector<LatticePoint>;

/// All of them with 3 to `most` vertices on `side` x `side` points, sorted.
/// Requires: 2 <= side, 3 <= most.
std::vector<GridPolygon> grid_polygons(int side, std::size_t most);

/// The polygon after one of the eight symmetries of the square, 0 the identity.
GridPolygon image(const GridPolygon& polygon, std::size_t symmetry);
inline constexpr std::size_t square_symmetries = 8;

Region region_of(const GridPolygon& polygon);

/// Pairs of grid polygons up to what keeps their sum, but for its place: exchanging them, moving
/// each, and the square's symmetries applied to both. One pair of each orbit, as indices of polygons,
/// the smallest one, in lexicographic order.
std::vector<std::pair<std::uint32_t, std::uint32_t>> pair_orbits(
    const std::vector<GridPolygon>& polygons);

}  // namespace oplus
