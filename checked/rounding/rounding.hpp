// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "checked/rounding/side.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// A set with all vertices on a grid.
struct RoundedSet {
  PlanarSet set;
  /// The set without edges and points; the interior of each component is connected, as others want it of polygons.
  /// Where the set is unbounded, the last component is the one without an outer chain.
  Region region;
  TopologyChanges changes;
  bool is_exact = true;  ///< whether the set is the given one, which was on the grid

  /// How far the two sets' difference, and the new boundary, are from the given boundary at most, in x and in y: half
  /// a step for Side::nearest, a step for the others, zero for what was on the grid. The distance is at
  /// most √2 times that.
  Rational bound = 0;
};

/// Rounds a set to the points (i step, j step), i and j integers: docs/rounding.md, which proves these laws.
///  1. The result is valid: chains that may touch but don't cross, with all vertices on the grid. Dangling edges
///     and isolated vertices are there, too; where they cross, they need not.
///  2. Where the two sets differ, and on the new boundary, the given boundary is at most `bound` away, in x and in y.
///  3. Side::contain: the given set is contained in the result; Side::contained: the other way round.
///  4. A set on the grid is returned as it is. So rounding twice changes nothing.
/// The dangling edges and isolated vertices of an open set belong to its complement: nearest moves them, and what is left
/// of thin parts of the complement joins them; contain drops them; contained puts thin parts of the complement in
/// their place. Those of a closed set belong to it: the other way round.
/// Near-linear in the vertices, by experience. Requires: step > 0; the set is in canonical form.
RoundedSet rounded(const PlanarSet& set, Boundary boundary, const Rational& step, Side side);

/// Returns "2 holes closed, 1 component vanished", or an empty text.
std::string describe(const TopologyChanges& changes);

}  // namespace oplus
