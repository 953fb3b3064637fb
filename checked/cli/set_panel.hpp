// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/definitions/planar_set.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

/// The drawing of a summand that may have edges and points of its own; its title says how many of each.
/// Requires: it is bounded.
Panel panel_of_set(Summand which, const PlanarSet& set);

}  // namespace oplus
