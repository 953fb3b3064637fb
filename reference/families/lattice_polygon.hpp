// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "reference/definitions/region.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// A point of a small grid; machine integers, because grid polygons are made by the million.
struct LatticePoint {
  int x;
  int y;

  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// Returns a simple polygon, counterclockwise, with exactly these vertices: in a random order, in
/// which edges that meet are exchanged until none do. Each simple polygon has a chance, since the
/// order may be its own at once. None where that does not succeed soon, as for points on a line.
/// Requires: distinct points.
std::optional<Chain> polygon_through(Random& random, std::vector<LatticePoint> points);

/// The grid polygons of 3 to `most` vertices, coordinates 0 to side - 1: each simple one has a
/// chance; vertices inside a straight line are favoured. Requires: side >= 2, 3 <= most.
Chain lattice_polygon(Random& random, int side, std::size_t most);

/// Returns a simple polygon of 3 to `most` vertices on integer points inside or on `around`, or
/// empty where the draw failed. Its edges may still cross those of `around`.
/// Requires: integer coordinates.
std::optional<Chain> lattice_polygon_within(Random& random, const Chain& around, std::size_t most);

}  // namespace oplus
