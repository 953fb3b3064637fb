// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/region.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus::smt {

/// A simple polygon that has this corner in the origin, and from there sees all of itself.
/// Requires: the corner does not turn back.
Region region_with_corner(const Corner& corner);

/// A simple polygon that has the origin inside an edge of this direction, and from there sees all of
/// itself; it fills a half disk of that radius, at least.
Region region_with_edge(const Vector& edge, const Rational& radius);

}  // namespace oplus::smt
