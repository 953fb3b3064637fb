// SPDX-License-Identifier: MIT
#pragma once

#include "reference/io/placed_geometry.hpp"

#include "reference/chains/validity.hpp"

namespace oplus {

/// Throws InvalidInput that names the chains, edges and vertices of a defect as the input has them:
/// numbered from one, in the input's order. The place is the later one of the two.
[[noreturn]] void refuse_defect(const InputText& input, const PlacedGeometry& geometry,
                                const Defect& defect);

}  // namespace oplus
