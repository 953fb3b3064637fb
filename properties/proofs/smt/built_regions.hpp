// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/region.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus::smt {

/// A simple polygon with this corner at the origin, star-shaped as seen from there. Empty if
/// the corner turns back, and so has no sector.
Region region_with_corner(const Corner& corner);

/// A simple polygon with the origin inside an edge of this direction, star-shaped as seen from
/// there; it contains a half disk of at least that radius.
Region region_with_edge(const Vector& edge, const Rational& radius);

}  // namespace oplus::smt
