// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/region.hpp"

namespace oplus {

/// Of the corners of the intersection of P and -Q+x, those at which d is a tangent direction, each with
/// a sign: vertices of P in -Q+x whose tangent set has d, vertices of Q in -P+x whose tangent set has
/// -d, and crossings of edges (docs/winding.md). It is the winding number of x with respect to the
/// convolution, for each d; for regions no corner counts negative. Asks no point for its side of a
/// segment of the convolution. Takes any closed chains, which may cross themselves; x may be anywhere, if
/// winding numbers on a chain are those of winding_number(). O(nm). Requires: d is not zero.
int tangent_count(const Point& x, const Region& p, const Region& q, const Vector& d);

}  // namespace oplus
