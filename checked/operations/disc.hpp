// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "checked/operations/disc_side.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// Returns the largest number that is 1, 2 or 5 times a power of ten and not above x, so that its
/// multiples are short decimals. Requires: x > 0.
Rational short_step(const Rational& x);

/// Whether a chain is a convex polygon around the disc of radius `inner` about the origin and inside the
/// disc of radius `outer`, decided exactly: each edge is at least `inner` away from the origin, to its left,
/// each vertex at most `outer`, and the chain turns left at each vertex, once around.
/// Requires: 0 <= inner <= outer.
bool is_between_discs(const Chain& chain, const Rational& inner, const Rational& outer);

/// Returns such a polygon (docs/discs.md):
///  1. its coordinates are multiples of short_step((outer - inner) / 10);
///  2. it is symmetric under quarter turns and under reflections in the axes and the diagonals, and starts
///     on the positive x-axis, counterclockwise;
///  3. any such polygon has at least π / arccos(inner / outer) vertices, for narrow rings about
///     π / √(2 (outer - inner) / outer); it has at most a tenth more, and up to 8.
/// Nothing if that would be more than `most` vertices. Requires: 0 <= inner < outer.
/// Cost: about twenty times the number of vertices.
std::optional<Chain> polygon_between_discs(const Rational& inner, const Rational& outer,
                                           unsigned long most);

/// Returns a polygon for the disc of a radius about the origin: between that and the disc of a smaller radius,
/// by `error`, or of a larger one. Throws InvalidInput unless both are positive and a million vertices are
/// enough.
Region disc_polygon(const Rational& radius, DiscSide side, const Rational& error);

}  // namespace oplus
